(run with: --machine lathe2)
O1 (the first block of the shape is an arc)
G97S500M03
G00X80.Z2.
G71U2.R1.
G71P10Q50U.4W.1F.3
N10G02X40.Z2.R30.
G01Z-20.F.15
N50X80.
M30
(finally alarm PS0065)
