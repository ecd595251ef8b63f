(run with: --machine lathe2)
O1 (MRC-2)
G97S500M03
G00X100.Z2.
G71U0R1. (expect alarm PS0062)
M30
