(run with: --machine lathe2)
O1 (M08 is no move)
G98 G00 X20. Z0.
G01 Z-15. ,R2. F100
M08
X40.
M30
(finally moves: rapid X20 Z0; line X20 Z-13; cw X24 Z-15; line X40 Z-15)
