(run with: --machine lathe2 --param gsystem=B)
O1 (system B: G90 G91, G92 S, G95, G77 and G78)
G92S2000
G97S500M03
G90G95G00X52.Z2.
G77X46.Z-30.F.2
G00X40.
G91G01X-4.Z-3.
G90G00X34.Z4.
G78X28.Z-20.F1.5
G00X60.
M30
(finally moves: rapid X52 Z2; rapid X46 Z2; line X46 Z-30; line X52 Z-30; rapid X52 Z2; rapid X40 Z2; line X36 Z-1; rapid X34 Z4; rapid X28 Z4; thread X28 Z-18.5 F1.5; thread X31 Z-20 F1.5; rapid X34 Z-20; rapid X34 Z4; rapid X60 Z4)
