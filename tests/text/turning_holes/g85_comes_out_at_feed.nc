(run with: --machine lathe3c)
O1 (Holes)
G98
G00X30.Z20.C0
G85W-10.R-15.F100 (expect moves: rapid Z5; line Z-5; line Z5; rapid Z20)
M30
