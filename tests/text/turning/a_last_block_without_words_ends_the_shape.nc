(run with: --machine lathe2)
O1 (N50 alone)
G97S500M03
G00X50.Z2.
G71U5.R1.
G71P10Q50U0W0F.3
N10G00X40.
G01Z-20.
X50.
N50
G00X60. (expect moves: rapid X60 Z2)
G70P10Q50
G00X70. (expect moves: rapid X70 Z2)
M30
