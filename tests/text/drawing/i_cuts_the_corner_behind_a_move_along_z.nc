(run with: --machine lathe2)
O1 (2 mm along Z, 2 mm of radius along X)
G98 G00 X20. Z0.
G01 Z-20. I2. F100
X40.
M30
(finally moves: rapid X20 Z0; line X20 Z-18; line X24 Z-20; line X40 Z-20)
