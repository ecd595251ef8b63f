(run with: --machine lathe2)
O1 (PS0306: I stands behind a move along Z)
G98 G00 X20. Z0.
G01 Z-20. K2. F100 (expect alarm PS0306 at K2.)
X40.
M30
