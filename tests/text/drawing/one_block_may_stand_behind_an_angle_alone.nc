(run with: --machine lathe2)
O1 (the dwell comes where the lines cross)
G98 G00 X20. Z0.
G01 ,A170. F100
G04 P500
X50. Z-40. ,A135.
M30
(finally moves: rapid X20 Z0; line X30.7037 Z-30.3519; line X50 Z-40)
(finally records: dwell 0.5)
