(run with: --machine lathe2)
O1 (PS0058: the second line has no end either)
G98 G00 X20. Z0.
G01 ,A170. F100
,A135. (expect alarm PS0058 at ,A135.)
X50. Z-40. ,A150.
M30
