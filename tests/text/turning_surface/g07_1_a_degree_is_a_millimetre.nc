(run with: --machine lathe3c)
O1 (Cylindrical interpolation)
G98G18
G00X114.592Z-10.C0
G07.1C57.296
G01C30.F250 (expect moves: line Z-10 C30 F250)
G02Z-40.C60.R30. (expect moves: cw Z-40 C60 @-10,60.0001 ZC)
G01Z-60. (expect moves: line Z-60 C60)
G07.1C0
G00C0 (expect moves: rapid C0)
M30
