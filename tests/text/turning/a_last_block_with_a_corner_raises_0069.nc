(run with: --machine lathe2)
O1 (the corner needs a further block)
G97S500M03
G00X100.Z2.
G71U2.R1.
G71P10Q50F.3
N10G00X40.
G01Z-20.
N50X100.,R2. (expect alarm PS0069)
M30
