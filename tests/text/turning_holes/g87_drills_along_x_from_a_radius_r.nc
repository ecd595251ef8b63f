(run with: --machine lathe3c)
O1 (Holes)
G98
G00X80.Z-10.C0
G87X40.C45.R-10.F100 (expect moves: rapid X80 C45; rapid X60; line X40; rapid X80)
Z-20. (expect moves: rapid X80 Z-20; rapid X60; line X40; rapid X80)
M30
