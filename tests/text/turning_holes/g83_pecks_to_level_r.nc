(run with: --machine lathe3c)
O1 (Holes)
G98
G00X100.Z20.C0
G83X60.C30.Z-20.R-15.Q10000P500F100 (expect moves: rapid X60 C30 Z20; rapid Z5; line Z-5 F100; rapid Z5; rapid Z-4.5; line Z-15; rapid Z5; rapid Z-14.5; line Z-20; rapid Z20)
G80
M30
(finally records: dwell 0.5)
