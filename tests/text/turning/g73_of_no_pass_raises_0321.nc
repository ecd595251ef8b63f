(run with: --machine lathe2)
O1 (R of G73)
G97S500M03
G00X84.Z2.
G73U2.W2.R0 (expect alarm PS0321 at R0)
M30
