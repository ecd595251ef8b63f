(run with: --machine lathe2 --set #2901=.75 --set #2201=.05 --set #2301=3)
O1 (turning, nose radius: #2900 and #2200 together)
G00 X60. Z5. T0101
G42 G00 X20. Z2. (expect moves: rapid X20 Z1.2)
G01 Z-10. F.1
G40 G00 X60.
M30
