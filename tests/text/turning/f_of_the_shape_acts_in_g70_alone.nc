(run with: --machine lathe2)
O1 (the cycle's own F roughs)
G97S500M03
G00X50.Z2.
G71U5.R1.
G71P10Q50U0W0F.3
N10G00X40.
G01Z-20.F.12 (expect moves: line X40 Z-20 F0.3; line X40 Z-20 F0.12)
N50X50. (expect moves: line X50 F0.3; line X50 F0.12; rapid X50 Z2)
G70P10Q50
M30
