(run with: --machine lathe2)
O1 (Spindle and feed)
G97S500M03
G00X30.Z1.7
G32Z-20.F2.
G00X40.
G00X30.Z1.6
G32Z-20.F2. (expect assumed: the thread begins 1.6 mm before Z0; for a lead within 2 % it needs 1.618 mm)
M30
