(run with: --machine lathe3c --param stroke_check=0)
O1 (Polar interpolation)
G98
G00X-20.Z2.C0
G12.1
G01C10.F200 (expect moves: line X-28.2843 C-45)
G13.1
M30
