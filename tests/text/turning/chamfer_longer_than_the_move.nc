(run with: --machine lathe2)
O1 (chamfer longer than the move)
G97S500M03
G00X20.Z2.
G01Z-1.,C5.F.2
X40.
M30
(finally alarm PS0055)
