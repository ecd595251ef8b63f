(run with: --machine lathe2)
O1 (G17)
G17
G97S500M03
G00X100.Z2.
G71U2.R1. (expect alarm PS0327)
M30
