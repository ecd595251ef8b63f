(run with: --machine lathe2)
O1 (the last block stands behind the first)
G97S500M03
G00X100.Z2.
G71U2.R1.
G71P50Q10F.3 (expect alarm PS0063 at Q10)
N10G00X40.
G01Z-20.
N50X100.
M30
