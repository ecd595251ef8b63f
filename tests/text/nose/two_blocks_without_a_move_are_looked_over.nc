(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: the corner is still seen)
G97 S500 M03
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10. F.1 (expect moves: line X20 Z-10)
M08
M09
X40.
G40 G00 X60. Z5.
M30
(finally assumed: none)
