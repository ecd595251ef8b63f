(run with: --machine lathe2 --param MRC=1)
O1 (G72 knows no pockets)
G97S500M03
G00X84.Z2.
G72W2.R1.
G72P10Q50F.3 (expect alarm PS0323)
N10G00X80.Z-20.
N50G01X40.Z-10.
M30
