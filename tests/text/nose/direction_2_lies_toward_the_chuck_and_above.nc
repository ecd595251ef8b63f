(run with: --machine lathe2 --set #2901=0.8 --set #2301=2)
O1 (turning, nose radius: the tip of direction 2 lies toward the chuck and above)
G97 S500 M03
G00 X60. Z5. T0101
G42 G00 X20. Z2. (expect moves: rapid X23.2 Z1.2)
G01 Z-10. F.1 (expect moves: line X23.2 Z-10.4686)
X40. Z-20. (expect moves: line X43.2 Z-20.4686)
Z-30. (expect moves: line X43.2 Z-30.8)
G40 G00 X60. Z5. (expect moves: rapid X60 Z5)
M30
