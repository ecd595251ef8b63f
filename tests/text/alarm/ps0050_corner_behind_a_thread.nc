(run with: --machine lathe2)
O1 (PS0050: a thread ends in no corner)
G98 G00 X20. Z0.
G97 S500 M03
G32 Z-20. F1.5 ,C2. (expect alarm PS0050 at ,C2.)
X40.
M30
