(run with: --machine lathe2)
O1 (G32 chain: cylinder, then cone, then out; retreats by G00)
G97S500M03
G00X30.Z5.
G00X27.
G32Z-20.F2.
G32X31.Z-26.
G00X40.
Z5.
M30
(finally moves: rapid X30 Z5; rapid X27 Z5; thread X27 Z-20 F2; thread X31 Z-26 F2; rapid X40 Z-26; rapid X40 Z5)
