(run with: --machine lathe2)
O1 (PS0312: one block without a move may stand there)
G98 G00 X20. Z0.
G01 Z-20. ,R2. F100 (expect alarm PS0312)
M08
M09
X40.
M30
