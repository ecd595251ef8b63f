(run with: --machine lathe2)
O1 (turning, nose radius: G42 with nose radius 0)
G00 X60. Z5. T0101
G42 G00 X20. Z2. (expect moves: rapid X20 Z2) (expect assumed: compensates nothing)
G01 X30. Z-10. F.1 (expect moves: line X30 Z-10)
G40 G00 X60.
M30
