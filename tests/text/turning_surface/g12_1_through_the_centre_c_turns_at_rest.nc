(run with: --machine lathe3c)
O1 (Polar interpolation)
G98
G00X40.Z2.C0
G12.1
G01X-40.F200 (expect moves: line X40 C180)
X-30.C0 (expect moves: line X30 C180)
G13.1
M30
