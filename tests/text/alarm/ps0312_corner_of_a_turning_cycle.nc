(run with: --machine lathe2)
O1 (PS0312: a cycle has no corner)
G98 G00 X20. Z0.
G90 X18. Z-20. ,C2. F100 (expect alarm PS0312 at ,C2.)
M30
