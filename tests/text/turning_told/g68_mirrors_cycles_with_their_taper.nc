(run with: --machine lathe2)
O1 (Second turret)
G97S500M03
G00X52.Z2.
G68
G00X52.Z2.
G90X46.Z-30.R-3.F.2 (expect moves: rapid X-40 Z2; line X-46 Z-30; line X-52 Z-30; rapid X-52 Z2)
G00X62.
M30
