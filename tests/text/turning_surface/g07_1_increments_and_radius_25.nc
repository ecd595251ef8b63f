(run with: --machine lathe3c)
O1 (Cylindrical interpolation)
G98G18
G00X50.Z-5.C40.
G107C25.
G02Z-15.C62.918R10.F100 (expect moves: cw Z-15 C62.918 @-5,27.4533 ZC)
G01H-22.918W10. (expect moves: line Z-5 C40)
G107C0
M30
