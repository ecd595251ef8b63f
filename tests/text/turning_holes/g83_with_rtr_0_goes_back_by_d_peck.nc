(run with: --machine lathe3c --param RTR=0)
O1 (Holes)
G98
G00X60.Z20.C0
G83Z-10.R-15.Q8.F100 (expect moves: rapid Z5; line Z-3; rapid Z-2.5; line Z-10; rapid Z20)
M30
