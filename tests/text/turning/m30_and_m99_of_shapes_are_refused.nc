(run with: --machine lathe2)
O1 (M30 in a shape)
G97S500M03
G00X100.Z2.
G71U2.R1.
G71P10Q50F.3
N10G00X40.
M30 (expect alarm PS0325 at M30)
N50G01X100.
M30
