(run with: --machine lathe2 --set #2901=0.8 --set #2301=3 --param 5130=0)
O1 (turning, nose radius: G92)
G97 S500 M03
G00 X60. Z5. T0101
G42
G92 X46. Z-20. F2. (expect moves: rapid X46 Z5; thread X46 Z-20; rapid X60 Z-20; rapid X60 Z5)
G40
M30
