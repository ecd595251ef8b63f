(run with: --machine lathe2 --param 3401#6=1)
O1 (Words)
G92S2000
G97S500M03
G90G95G00X52.Z2.
G77X46.Z-30.F.2 (expect moves: rapid X46; line Z-30; line X52; rapid Z2)
M30
