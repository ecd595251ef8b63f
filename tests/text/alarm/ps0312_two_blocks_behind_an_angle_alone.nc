(run with: --machine lathe2)
O1 (PS0312: one block without a move may stand there)
G98 G00 X20. Z0.
G01 ,A170. F100 (expect alarm PS0312)
M08
M09
X50. Z-40. ,A135.
M30
