(run with: --machine lathe2 --param 5133=0.7)
O1 (one-block form G71 P Q U W D F; retreat from parameter 5133)
G97S500M03
G00X60.Z2.
G71P10Q50U.4W.1D2.5F.3
N10G00X30.
G01Z-20.F.15
G01X44.Z-30.
N50G01X60.
M30
(finally moves: rapid X60 Z2; rapid X60.4 Z2.1; rapid X55.4 Z2.1; line X55.4 Z-29.9; rapid X56.8 Z-29.2; rapid X56.8 Z2.1; rapid X50.4 Z2.1; line X50.4 Z-29.9; rapid X51.8 Z-29.2; rapid X51.8 Z2.1; rapid X45.4 Z2.1; line X45.4 Z-29.9; rapid X46.8 Z-29.2; rapid X46.8 Z2.1; rapid X40.4 Z2.1; line X40.4 Z-27.0429; rapid X41.8 Z-26.3429; rapid X41.8 Z2.1; rapid X35.4 Z2.1; line X35.4 Z-23.4714; rapid X36.8 Z-22.7714; rapid X36.8 Z2.1; rapid X30.4 Z2.1; line X30.4 Z-19.9; rapid X31.8 Z-19.2; rapid X31.8 Z2.1; rapid X30.4 Z2.1; line X30.4 Z-19.9; line X44.4 Z-29.9; line X60.4 Z-29.9; rapid X60 Z2)
(finally work X60 Z2)
