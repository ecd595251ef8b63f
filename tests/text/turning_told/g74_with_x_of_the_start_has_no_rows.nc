(run with: --machine lathe2)
O1 (Pecks and threads)
G97S500M03
G00X-.812Z.1
G74R.04
G74X-.812Z-1.3Q800F.1 (expect moves: line Z-0.7; rapid Z-0.66; line Z-1.3; rapid Z0.1)
M30
