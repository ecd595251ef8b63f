(run with: --machine lathe2)
O1 (the lines cross, then the corner is rounded)
G98 G00 X20. Z0.
G01 ,A170. ,R5. F100
X50. Z-40. ,A135.
M30
(finally moves: rapid X20 Z0; line X30.1562 Z-28.7993; cw X32.9332 Z-31.4666 @-27.9311,40.0043 ZX; line X50 Z-40)
