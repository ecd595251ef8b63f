(run with: --machine lathe2)
O1 (the other coordinate follows: 10 / tan 150 from Z0)
G98 G00 X20. Z0.
G01 X40. ,A150. F100 (expect moves: line X40 Z-17.3205)
M30
