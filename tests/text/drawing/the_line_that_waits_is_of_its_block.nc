(run with: --machine lathe2)
O1 (its exact stop too)
G98 G00 X20. Z0.
G01 G09 ,A170. F100 (expect moves: line stop)
X50. Z-40. ,A135. (expect moves: line pass)
Z-50.
M30
