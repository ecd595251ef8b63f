(run with: --machine lathe2)
O1 (PS0145)
G98G00X40.Z2.
G12.1 (expect alarm PS0145)
M30
