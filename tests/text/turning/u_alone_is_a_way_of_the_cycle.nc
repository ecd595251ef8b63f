(run with: --machine lathe2)
O1 (C is no axis of lathe2, so U of X goes and Z stays)
G97S500M03
G00X52.Z2.
G90U-6.Z-30.F.2 (expect moves: rapid X46 Z2; line X46 Z-30; line X52; rapid Z2)
M30
