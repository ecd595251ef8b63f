(run with: --machine lathe2)
O1 (G74: rows with relief, none in the first)
G97S500M03
G00X30.Z2.
G74R.4
G74X22.Z-12.P1500Q5000R.2F.08
M30
(finally moves: rapid X30 Z2; line X30 Z-3; rapid X30 Z-2.6; line X30 Z-8; rapid X30 Z-7.6; line X30 Z-12; rapid X30 Z2; rapid X27 Z2; line X27 Z-3; rapid X27 Z-2.6; line X27 Z-8; rapid X27 Z-7.6; line X27 Z-12; rapid X27.4 Z-12; rapid X27.4 Z2; rapid X24 Z2; line X24 Z-3; rapid X24 Z-2.6; line X24 Z-8; rapid X24 Z-7.6; line X24 Z-12; rapid X24.4 Z-12; rapid X24.4 Z2; rapid X22 Z2; line X22 Z-3; rapid X22 Z-2.6; line X22 Z-8; rapid X22 Z-7.6; line X22 Z-12; rapid X22.4 Z-12; rapid X22.4 Z2; rapid X30 Z2)
