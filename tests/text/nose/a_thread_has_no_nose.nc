(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: G32 is a move without compensation)
G97 S500 M03
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 Z0 F.1 (expect moves: line X20 Z-0.8)
G32 Z-20. F2. (expect moves: thread X20 Z-20)
G40 G00 X60.
M30
