(run with: --machine lathe3c)
O1 (PS0176)
G98
G00X60.Z2.C0
G07.1C30.
G00Z0 (expect alarm PS0176 at G00)
M30
