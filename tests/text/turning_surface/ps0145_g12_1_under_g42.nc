(run with: --machine lathe3c)
O1 (PS0145)
G98G00X40.Z2.C0
G42
G12.1 (expect alarm PS0145)
M30
