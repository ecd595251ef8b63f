(run with: --machine lathe2 --set #2901=0.8 --set #2301=3 --set #2902=0.4 --set #2302=2)
O1 (turning, nose radius: T0202 in the middle, as another D, CRC-13)
G00 X60. Z5. T0101
G42 G00 X20. Z2. (expect moves: rapid X20 Z1.2)
G01 Z-10. F.1 (expect moves: line X20 Z-10.8; line X21.6 Z-10.4)
T0202
Z-20. (expect moves: line X21.6 Z-20)
X40. (expect moves: line X40.8 Z-20)
G40 G00 X60. Z5.
M30
