(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: G42 stands, T0101 brings the radius)
G00 X60. Z5.
G42
T0101
X20. Z2. (expect moves: rapid X20 Z1.2)
G01 Z-10. F.1 (expect moves: line X20 Z-10.8)
G40 G00 X60.
M30
