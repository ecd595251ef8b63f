(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: behind the cycle none comes back)
G00 X40. Z2. T0101
G42
G71 U5. R.5
G40 G71 P10 Q20 U0 W0 F.3
N10 G00 X20.
G01 Z-10. F.1
N20 X40. Z-20.
G00 X30. Z2. (expect moves: rapid X30 Z2)
G01 X40. Z-10. (expect moves: line X40 Z-10)
M30
