(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: moves 2 and 3 of G90)
G00 X60. Z5. T0101
G42
G90 X46. Z-20. R-2. F.2 (expect moves: rapid X41.9949 Z4.2638; line X45.8771 Z-20; line X58.4 Z-20; rapid X60 Z5)
G40
M30
