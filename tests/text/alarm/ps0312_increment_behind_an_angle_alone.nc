(run with: --machine lathe2)
O1 (PS0312: it would count from an unknown point)
G98 G00 X20. Z0.
G01 ,A170. F100
X50. W-40. ,A135. (expect alarm PS0312 at ,A135.)
M30
