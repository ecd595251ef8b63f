(run with: --machine lathe2 --set #2901=0.8 --set #2301=3 --param SUP/SUV=B)
O1 (turning, nose radius: an outside corner at the start)
G00 X0 Z2. T0101
G42 G01 X20. F.1 (expect moves: line X20 Z2)
Z-10.
G40 G00 X60.
M30
