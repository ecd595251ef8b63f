(run with: --machine lathe3c)
O1 (Polar interpolation)
G99G97S500M03
G00X40.Z2.C0
G12.1 (expect assumed: G12.1 with feed per revolution)
G01C10.F.2
G13.1
M30
