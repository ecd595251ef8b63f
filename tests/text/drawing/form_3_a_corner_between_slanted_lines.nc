(run with: --machine lathe2)
O1 (an arc of 3 mm tangent to both)
G98 G00 X20. Z0.
G01 Z-20. ,R3. F100
X50. Z-30.
M30
(finally moves: rapid X20 Z0; line X20 Z-18.3944; cw X22.6718 Z-20.8906 @-18.3944,26 ZX; line X50 Z-30)
