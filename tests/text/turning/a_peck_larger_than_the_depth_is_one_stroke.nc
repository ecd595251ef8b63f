(run with: --machine lathe2)
O1 (P656565 of real programs)
G97S500M03
G00X46.Z-12.
G75R.5
G75X34.P656565F.08 (expect moves: line X34 Z-12; rapid X46 Z-12)
M30
