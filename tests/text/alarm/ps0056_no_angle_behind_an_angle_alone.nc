(run with: --machine lathe2)
O1 (PS0056: where the lines cross is not known)
G98 G00 X20. Z0.
G01 ,A170. F100
X50. Z-40. (expect alarm PS0056)
M30
