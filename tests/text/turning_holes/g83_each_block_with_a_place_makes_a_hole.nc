(run with: --machine lathe3c)
O1 (Holes)
G98
G00X60.Z20.C0
G83Z-4.R-18.F100
C90. (expect moves: rapid C90 Z20; rapid Z2; line Z-4; rapid Z20)
H90.K2 (expect moves: rapid C180 Z20; rapid Z2; line Z-4; rapid Z20; rapid C270 Z20; rapid Z2; line Z-4; rapid Z20)
G80
C0 (expect moves: rapid C0)
M30
