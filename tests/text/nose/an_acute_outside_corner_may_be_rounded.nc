(run with: --machine lathe2 --set #2901=0.8 --set #2301=3 --param CCC=1)
O1 (turning, nose radius: the arc about the corner is shifted with the tip)
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10. F.1
X40. (expect moves: line X38.4 Z-10; ccw X39.5314 Z-11.3657 @-10.8,38.4 ZX)
X20. Z-20.
G40 G00 X60.
M30
