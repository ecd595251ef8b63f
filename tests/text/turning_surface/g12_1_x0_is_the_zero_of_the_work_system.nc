(run with: --machine lathe3c)
O1 (Polar interpolation)
G98
G10P0X10.Z0
G00X40.Z2.C0
G12.1
G01X0C20.F200 (expect moves: line X50 C90)
G13.1
M30
