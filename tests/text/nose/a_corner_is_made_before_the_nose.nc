(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: chamfer first, then compensation)
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10.,R3. F.1 (expect moves: line X20 Z-7.8; cw X24.4 Z-10 @-7.8,24.4 ZX)
X40. (expect moves: line X38.4 Z-10)
G40 G00 X60.
M30
