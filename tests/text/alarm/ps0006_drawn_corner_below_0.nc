(run with: --machine lathe2)
O1 (PS0006: behind a comma a length stands)
G98 G00 X20. Z0.
G01 Z-20. ,R-2. F100 (expect alarm PS0006 at ,R-2.)
X40.
M30
