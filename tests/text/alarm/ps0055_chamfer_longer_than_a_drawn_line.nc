(run with: --machine lathe2)
O1 (PS0055: a line of 1 mm)
G98 G00 X20. Z0.
G01 Z-1. ,C5. F100 (expect alarm PS0055)
X40.
M30
