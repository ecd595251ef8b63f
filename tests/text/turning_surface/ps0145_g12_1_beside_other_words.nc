(run with: --machine lathe3c)
O1 (PS0145)
G98G00X40.Z2.
G12.1X30. (expect alarm PS0145 at G12.1)
M30
