(run with: --machine lathe3c)
O1 (Holes)
G97S500M03
G00X0Z1.
G83X0.Z-5.Q3.R0.3F.1 (expect moves: rapid Z1.3; line Z-1.7; rapid Z1.3; rapid Z-1.2; line Z-4.7; rapid Z1.3; rapid Z-4.2; line Z-5; rapid Z1)
G80
M30
