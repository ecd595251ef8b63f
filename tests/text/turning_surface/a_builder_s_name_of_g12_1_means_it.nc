(run with: --machine lathe3c --param stroke_check=0 --machine-set g_codes.G121=G12.1 --machine-set g_codes.G120=G13.1)
O1 (Polar interpolation by the names of some builders)
G98
G00X-20.Z2.C0
G121
G01C10.F200 (expect moves: line X-28.2843 C-45)
G120
G01C10.F200 (expect moves: line C10)
M30
