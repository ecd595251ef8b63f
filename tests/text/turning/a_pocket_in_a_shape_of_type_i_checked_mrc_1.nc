(run with: --machine lathe2 --param MRC=1)
O1 (a pocket in a shape of type I, checked MRC=1)
G97S500M03
G00X80.Z2.
G71U2.R1.
G71P10Q50U.4W.1F.3
N10G00X40.
G01Z-20.F.15
X30.Z-30.
N50X80.
M30
(finally alarm PS0329)
