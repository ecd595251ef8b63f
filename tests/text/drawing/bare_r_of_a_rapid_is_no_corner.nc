(run with: --machine lathe2)
O1 (told and ignored)
G98 G00 X20. Z0.
G00 X40. R2. (expect assumed: R2 is ignored)
Z-30.
M30
(finally moves: rapid X20 Z0; rapid X40; rapid Z-30)
