(run with: --machine lathe2)
O1 (P missing in the second block)
G97S500M03
G00X80.Z2.
G71U2.R1.
G71Q50U.4W.1F.3
N10G00X40.
N20G01Z-20.F.15
N50X80.
M30
(finally alarm PS0061)
