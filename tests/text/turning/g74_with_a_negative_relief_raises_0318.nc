(run with: --machine lathe2)
O1 (R of G74)
G97S500M03
G00X30.Z2.
G74R.4
G74X22.Z-12.P1500Q5000R-.2F.08 (expect alarm PS0318 at R-.2)
M30
