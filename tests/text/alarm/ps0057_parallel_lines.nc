(run with: --machine lathe2)
O1 (PS0057: they do not cross)
G98 G00 X20. Z0.
G01 ,A170. F100
X50. Z-40. ,A350. (expect alarm PS0057 at ,A350.)
M30
