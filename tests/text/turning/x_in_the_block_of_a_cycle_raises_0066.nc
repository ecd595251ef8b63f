(run with: --machine lathe2)
O1 (X and Z belong to the shape)
G97S500M03
G00X100.Z2.
G71P10Q50X40.F.3 (expect alarm PS0066)
N10G00X40.
N50G01Z-20.
M30
