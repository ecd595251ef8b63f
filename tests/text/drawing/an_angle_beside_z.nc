(run with: --machine lathe2)
O1 (X follows: 20 tan 10 is 3.5265 of radius)
G98 G00 X20. Z0.
G01 Z-20. ,A170. F100 (expect moves: line X27.0531 Z-20)
M30
