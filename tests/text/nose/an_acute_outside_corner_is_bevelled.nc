(run with: --machine lathe2 --set #2901=0.8 --set #2301=9)
O1 (turning, nose radius: a spur of 45 degrees, CRC-9)
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10. F.1
X40. (expect moves: line X41.6 Z-9.2; line X42.2627 Z-10)
X20. Z-20.
G40 G00 X60.
M30
