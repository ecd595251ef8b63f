(run with: --machine lathe3c)
O1 (PS0146)
G98
G00X60.Z2.C0
G12.1
G00X50. (expect alarm PS0146 at G00)
M30
