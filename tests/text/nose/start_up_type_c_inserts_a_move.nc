(run with: --machine lathe2 --set #2901=0.8 --set #2301=3 --param SUP/SUV=C)
O1 (turning, nose radius: G42 alone, then a move)
G00 X20. Z2. T0101
G42
G01 Z-10. F.1 (expect moves: line X20 Z1.2; line X20 Z-10.8)
G40 G00 X60.
M30
