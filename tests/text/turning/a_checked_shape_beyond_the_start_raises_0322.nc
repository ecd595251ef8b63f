(run with: --machine lathe2 --param MRC=1)
O1 (the shape ends at 120, the tool stands at 100)
G97S500M03
G00X100.Z2.
G71U2.R1.
G71P10Q50F.3
N10G00X40.
G01Z-20.
N50X120. (expect alarm PS0322)
M30
