(run with: --machine lathe2)
O1 (2 mm along either line)
G98 G00 X20. Z0.
G01 Z-20. ,C2. F100
X50. Z-30.
M30
(finally moves: rapid X20 Z0; line X20 Z-18; line X23.3282 Z-21.1094; line X50 Z-30)
