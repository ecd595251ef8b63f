(run with: --machine lathe2 --set #2901=-0.8 --set #2301=9)
O1 (turning, nose radius: G41 is G42 then)
G00 X60. Z5. T0101
G41 G00 X20. Z2. (expect moves: rapid X21.6 Z2)
G01 Z-10. F.1 (expect moves: line X21.6 Z-10)
G40 G00 X60.
M30
