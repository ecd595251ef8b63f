(run with: --machine lathe2)
O1 (PS0054: the next move goes along X alone)
G98 G00 X20. Z0.
G01 Z-20. I2. F100
X40. Z-30. (expect alarm PS0054)
M30
