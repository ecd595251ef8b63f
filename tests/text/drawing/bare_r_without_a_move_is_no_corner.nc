(run with: --machine lathe2)
O1 (told and ignored)
G98 G00 X20. Z0.
G01 X40. F100
R2. (expect assumed: R2 is ignored)
Z-30.
M30
(finally moves: rapid X20 Z0; line X40; line Z-30)
