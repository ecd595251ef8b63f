(run with: --machine lathe2)
O1 (turning, nose radius: R and Q of G10)
G10 P10001 R.8 Q3
G00 X60. Z5. T0101
G42 G00 X20. Z2. (expect moves: rapid X20 Z1.2)
G01 Z-10. F.1
G40 G00 X60.
M30
