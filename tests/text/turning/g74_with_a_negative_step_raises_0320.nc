(run with: --machine lathe2)
O1 (P of G74)
G97S500M03
G00X30.Z2.
G74X22.Z-12.P-1500Q5000F.08 (expect alarm PS0320 at P-1500)
M30
