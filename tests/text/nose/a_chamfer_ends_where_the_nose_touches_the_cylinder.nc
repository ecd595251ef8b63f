(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: r tan 22.5 degrees before its head)
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 X26. Z-1. F.1 (expect moves: line X26 Z-1.4686)
Z-20.
G40 G00 X80. Z10.
M30
