(run with: --machine lathe2)
O1 (PS0058: Z is missing)
G98 G00 X20. Z0.
G01 ,A170. F100
X50. ,A135. (expect alarm PS0058 at ,A135.)
M30
