(run with: --machine lathe2)
O1 (PS0051: nothing comes behind the corner)
G98 G00 X20. Z0.
G01 Z-20. ,R2. F100 (expect alarm PS0051)
M30
