(run with: --machine lathe2)
O1 (N10 of every section: forward from the cycle)
G97S500M03
G00X50.Z2.
G71U5.R1.
G71P10Q20U0W0F.3
N10G00X40.
N20G01Z-20. (expect moves: line X40 Z-20)
G00X50.Z2.
G71P10Q20U0W0F.3
N10G00X45.
N20G01Z-10. (expect moves: line X45 Z-10)
M30
