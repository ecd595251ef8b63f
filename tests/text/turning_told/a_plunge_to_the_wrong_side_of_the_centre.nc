(run with: --machine lathe2)
O1 (Drawing dimensions)
G97S500M03
G00X-17.6Z0
G01X-21.75,A30.F.1 (expect moves: line X-21.75 Z-3.594)
M30
