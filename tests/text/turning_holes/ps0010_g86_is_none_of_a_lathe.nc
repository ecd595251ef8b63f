(run with: --machine lathe3c)
O1 (PS0010)
G98G00X30.Z20.
G86Z-10.R-15.F100 (expect alarm PS0010 at G86)
M30
