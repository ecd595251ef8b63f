(run with: --machine lathe2)
O1 (PS0055: I above 0, and the next move goes to the axis)
G98 G00 X20. Z0.
G01 Z-20. I2. F100 (expect alarm PS0055)
X10.
M30
