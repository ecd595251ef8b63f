(run with: --machine lathe2 --param gsystem=C)
O1 (system C: G20 is the turning cycle, G71 means mm)
G71
G97S500M03
G90G95G00X52.Z2.
G20X46.Z-30.F.2
G00X60.
M30
(finally moves: rapid X52 Z2; rapid X46 Z2; line X46 Z-30; line X52 Z-30; rapid X52 Z2; rapid X60 Z2)
