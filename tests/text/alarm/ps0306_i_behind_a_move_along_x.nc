(run with: --machine lathe2)
O1 (PS0306: K stands behind a move along X)
G98 G00 X20. Z0.
G01 X40. I2. F100 (expect alarm PS0306 at I2.)
Z-20.
M30
