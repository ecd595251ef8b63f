(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: moves 2 and 3 of G94)
G00 X60. Z5. T0101
G41
G94 X20. Z-2. F.2 (expect moves: rapid X58.4 Z-2; line X20 Z-2; line X20 Z4.2; rapid X60 Z5)
G40
M30
