(run with: --machine lathe2 --set #2901=0.8 --set #2301=9)
O1 (turning, nose radius: the tip of direction 9 is the centre)
G97 S500 M03
G00 X60. Z5. T0101
G42 G00 X20. Z2. (expect moves: rapid X21.6 Z2)
G01 Z-10. F.1 (expect moves: line X21.6 Z-9.6686)
X40. Z-20. (expect moves: line X41.6 Z-19.6686)
Z-30. (expect moves: line X41.6 Z-30)
G40 G00 X60. Z5. (expect moves: rapid X60 Z5)
M30
