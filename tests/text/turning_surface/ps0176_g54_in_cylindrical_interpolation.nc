(run with: --machine lathe3c)
O1 (PS0176)
G98
G00X60.Z2.C0
G07.1C30.
G54 (expect alarm PS0176 at G54)
M30
