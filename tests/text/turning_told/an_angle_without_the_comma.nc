(run with: --machine lathe2)
O1 (Drawing dimensions)
G97S500M03
G00X30.Z0
G01X40.0A-45.0F.1 (expect moves: line X40 Z-5)
M30
