(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: an outside corner of 90 degrees)
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10. F.1
X40. (expect moves: line X40 Z-10)
Z-20.
G40 G00 X80. Z10.
M30
