(run with: --machine lathe2)
O1 (a machine of X and Z)
G98 G00 X20. Z0.
G01 Z-15. C1.5 F100 (expect assumed: without a comma)
X40. R2.
Z-30.
M30
(finally moves: rapid X20 Z0; line X20 Z-13.5; line X23 Z-15; line X36 Z-15; ccw X40 Z-17; line X40 Z-30)
