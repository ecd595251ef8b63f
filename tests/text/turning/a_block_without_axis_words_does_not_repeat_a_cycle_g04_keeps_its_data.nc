(run with: --machine lathe2)
O1 (a block without axis words does not repeat a cycle; G04 keeps its data, G00 clears them)
G97S500M03
G00X52.Z2.
G90X46.Z-30.F.2
M08
G04X1.
X42.
G00X60.
M30
(finally moves: rapid X52 Z2; rapid X46 Z2; line X46 Z-30; line X52 Z-30; rapid X52 Z2; rapid X42 Z2; line X42 Z-30; line X52 Z-30; rapid X52 Z2; rapid X60 Z2)
