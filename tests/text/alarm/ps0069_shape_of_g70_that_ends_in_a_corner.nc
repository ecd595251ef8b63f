(run with: --machine lathe2)
O1 (PS0069: a further block would be needed)
G98 G00 X60. Z2.
G70 P10 Q20
N10 G00 X10.
N20 G01 Z-20. ,R2. F100 (expect alarm PS0069)
M30
