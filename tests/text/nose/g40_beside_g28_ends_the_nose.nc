(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: no move in the plane begins it again)
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10. F.1
G40 G28 U0 W0
G00 X20. Z2. (expect moves: rapid X20 Z2)
G01 X30. Z-10. (expect moves: line X30 Z-10)
M30
