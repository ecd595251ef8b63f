(run with: --machine lathe2 --param 5133=0.5)
O1 (D without a point counts increments: D2500 is 2.5 mm)
G97S500M03
G00X60.Z2.
G71P10Q50U.4W.1D2500F.3
N10G00X30.
G01Z-20.F.15
G01X44.Z-30.
N50G01X60.
M30
(finally moves: rapid X60 Z2; rapid X60.4 Z2.1; rapid X55.4 Z2.1; line X55.4 Z-29.9; rapid X56.4 Z-29.4; rapid X56.4 Z2.1; rapid X50.4 Z2.1; line X50.4 Z-29.9; rapid X51.4 Z-29.4; rapid X51.4 Z2.1; rapid X45.4 Z2.1; line X45.4 Z-29.9; rapid X46.4 Z-29.4; rapid X46.4 Z2.1; rapid X40.4 Z2.1; line X40.4 Z-27.0429; rapid X41.4 Z-26.5429; rapid X41.4 Z2.1; rapid X35.4 Z2.1; line X35.4 Z-23.4714; rapid X36.4 Z-22.9714; rapid X36.4 Z2.1; rapid X30.4 Z2.1; line X30.4 Z-19.9; rapid X31.4 Z-19.4; rapid X31.4 Z2.1; rapid X30.4 Z2.1; line X30.4 Z-19.9; line X44.4 Z-29.9; line X60.4 Z-29.9; rapid X60 Z2)
(finally work X60 Z2)
