(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: T0100 in a block of its own)
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10. F.1 (expect moves: line X20 Z-10.8)
T0100
X40. Z-20. (expect moves: line X40 Z-20)
M30
