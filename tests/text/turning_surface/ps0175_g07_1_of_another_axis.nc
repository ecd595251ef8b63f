(run with: --machine lathe3c)
O1 (PS0175)
G98
G00X60.Z2.C0
G07.1Z30. (expect alarm PS0175)
M30
