(run with: --machine lathe2)
O1 (G94 straight and taper)
G97S500M03
G00X62.Z3.
G94X20.Z-2.F.2
Z-4.
G00X70.Z5.
G94X30.Z-3.R-2.
G00X80.
M30
(finally moves: rapid X62 Z3; rapid X62 Z-2; line X20 Z-2; line X20 Z3; rapid X62 Z3; rapid X62 Z-4; line X20 Z-4; line X20 Z3; rapid X62 Z3; rapid X70 Z5; rapid X70 Z-5; line X30 Z-3; line X30 Z5; rapid X70 Z5; rapid X80 Z5)
