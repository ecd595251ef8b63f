(run with: --machine lathe2)
O1 (the line between loses 2 and 1 mm)
G98 G00 X20. Z0.
G01 Z-15. ,C2. F100
X40. ,C1.
Z-40.
M30
(finally moves: rapid X20 Z0; line X20 Z-13; line X24 Z-15; line X38 Z-15; line X40 Z-16; line X40 Z-40)
