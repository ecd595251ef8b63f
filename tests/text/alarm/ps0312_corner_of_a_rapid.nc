(run with: --machine lathe2)
O1 (PS0312: corners lie between lines)
G98 G00 X20. Z0.
G00 Z-20. ,R2. (expect alarm PS0312 at ,R2.)
X40.
M30
