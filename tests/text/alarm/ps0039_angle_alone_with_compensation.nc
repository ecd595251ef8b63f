(run with: --machine lathe2)
O1 (PS0039: G42 would begin in one of two lines)
G98 G00 X20. Z0.
G01 ,A170. F100
G42 X50. Z-40. ,A135. (expect alarm PS0039)
M30
