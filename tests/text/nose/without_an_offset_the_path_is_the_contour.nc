(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: T0100 has no nose)
G00 X60. Z5. T0100
G42 G00 X20. Z2. (expect moves: rapid X20 Z2) (expect assumed: compensates nothing)
G01 X30. Z-10. F.1 (expect moves: line X30 Z-10)
G40 G00 X60.
M30
