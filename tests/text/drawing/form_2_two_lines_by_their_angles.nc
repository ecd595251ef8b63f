(run with: --machine lathe2)
O1 (they cross where the first one ends)
G98 G00 X20. Z0.
G01 ,A170. F100 (expect moves: line X30.7037 Z-30.3519)
X50. Z-40. ,A135. (expect moves: line X50 Z-40)
M30
