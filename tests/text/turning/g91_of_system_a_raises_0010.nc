(run with: --machine lathe2)
O1 (LAT-1)
G91G01X1. (expect alarm PS0010 at G91)
M30
