(run with: --machine lathe2)
O1 (but a bare G90 starts the turning cycle when X Z follow without G00)
G97S500M03
G00X52.Z2.
G90
X46.Z-30.F.2
G00X60.
M30
(finally moves: rapid X52 Z2; rapid X46 Z2; line X46 Z-30; line X52 Z-30; rapid X52 Z2; rapid X60 Z2)
