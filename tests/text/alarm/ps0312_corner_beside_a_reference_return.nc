(run with: --machine lathe2)
O1 (PS0312: G28 has no corner)
G98 G00 X20. Z0.
G28 U0 ,R2. (expect alarm PS0312 at ,R2.)
M30
