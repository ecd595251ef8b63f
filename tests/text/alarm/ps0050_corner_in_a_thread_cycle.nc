(run with: --machine lathe2)
O1 (PS0050: nor does one of a cycle)
G98 G00 X20. Z0.
G97 S500 M03
G76 X17. Z-16. K1. D400 F1.5 ,R2. (expect alarm PS0050 at ,R2.)
M30
