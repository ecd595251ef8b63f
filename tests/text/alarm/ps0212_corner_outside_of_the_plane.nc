(run with: --machine lathe2)
O1 (PS0212: drawings of a lathe lie in Z and X)
G98 G00 X20. Z0.
G17 G01 Z-20. ,R2. F100 (expect alarm PS0212 at ,R2.)
X40.
M30
