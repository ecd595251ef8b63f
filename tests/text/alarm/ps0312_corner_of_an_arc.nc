(run with: --machine lathe2)
O1 (PS0312: corners of a lathe lie between lines)
G98 G00 X20. Z0.
G03 X40. Z-20. R15. F100 ,R2. (expect alarm PS0312 at ,R2.)
Z-30.
M30
