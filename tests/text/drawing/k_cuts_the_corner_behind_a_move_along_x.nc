(run with: --machine lathe2)
O1 (the next move goes to -Z)
G98 G00 X20. Z0.
G01 X40. K-2. F100
Z-30.
M30
(finally moves: rapid X20 Z0; line X36 Z0; line X40 Z-2; line X40 Z-30)
