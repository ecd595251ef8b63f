(run with: --machine lathe2)
O1 (its sign is the direction of the next move)
G98 G00 X20. Z0.
G01 Z-20. I-2. F100
X10.
M30
(finally moves: rapid X20 Z0; line X20 Z-18; line X16 Z-20; line X10 Z-20)
