(run with: --machine lathe2)
O1 (PS0326: a further block would be needed)
G98 G00 X60. Z2.
G71 U2. R1.
G71 P10 Q20 U0 W0 F100
N10 G00 X10.
G01 Z-20.
N20 ,A135. (expect alarm PS0326)
M30
