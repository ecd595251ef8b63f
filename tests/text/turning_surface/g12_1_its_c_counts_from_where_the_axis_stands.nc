(run with: --machine lathe3c)
O1 (Polar interpolation)
G98
G00X40.Z2.C90.
G112
G01X40.C20.F200 (expect moves: line X56.5685 C135)
H-20. (expect moves: line X40 C90)
G113
G01C100.F360 (expect moves: line X40 C100)
M30
