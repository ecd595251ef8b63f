(run with: --machine lathe2)
O1 (PS0053: one of C, R, I and K)
G98 G00 X20. Z0.
G01 Z-20. I1. ,R2. F100 (expect alarm PS0053 at I1.)
X40.
M30
