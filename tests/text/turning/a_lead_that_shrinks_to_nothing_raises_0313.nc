(run with: --machine lathe2)
O1 (K of G34: 2 mm less 0.5 with each turn)
G97S500M03
G00X30.Z5.
G34Z-40.F2.K-.5 (expect alarm PS0313)
M30
