(run with: --machine lathe2)
O1 (PS0054: I stands behind a move along Z)
G98 G00 X20. Z0.
G01 X30. Z-20. I2. F100 (expect alarm PS0054 at I2.)
X40.
M30
