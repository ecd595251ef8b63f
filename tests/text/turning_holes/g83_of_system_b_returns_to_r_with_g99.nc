(run with: --machine lathe3c --param gsystem=B)
O1 (Holes)
G94G90
G00X60.Z20.C0
G99G83Z-10.R-15.F100 (expect moves: rapid Z5; line Z-10; rapid Z5)
G98C90. (expect moves: rapid Z5 C90; line Z-10; rapid Z20)
M30
