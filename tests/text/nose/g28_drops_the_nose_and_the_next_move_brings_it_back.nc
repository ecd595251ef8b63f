(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: G28 is a move without compensation)
G00 X60. Z5. T0101
G42 G00 X20. Z2. (expect moves: rapid X20 Z1.2)
G01 Z-10. F.1 (expect moves: line X20 Z-10.8)
G28 U0 (expect moves: rapid X20 Z-10; rapid X0 Z-10)
G01 X20. (expect moves: line X20 Z-10.8)
Z-20. (expect moves: line X20 Z-20.8)
G40 G00 X60.
M30
