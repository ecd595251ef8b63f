(run with: --machine lathe2)
O1 (G90 taper by R, U W form, repeated with U alone)
G97S500M03
G00X52.Z2.
G90U-8.W-32.R-3.F.2
U-12.
G00X60.
M30
(finally moves: rapid X52 Z2; rapid X38 Z2; line X44 Z-30; line X52 Z-30; rapid X52 Z2; rapid X34 Z2; line X40 Z-30; line X52 Z-30; rapid X52 Z2; rapid X60 Z2)
