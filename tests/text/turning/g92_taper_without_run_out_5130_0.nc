(run with: --machine lathe2 --param 5130=0)
O1 (G92 taper without run-out 5130=0)
G97S500M03
G00X30.Z5.
G92X25.Z-30.R-1.2F2.
X24.2
G00X40.
M30
(finally moves: rapid X30 Z5; rapid X22.6 Z5; thread X25 Z-30 F2; rapid X30 Z-30; rapid X30 Z5; rapid X21.8 Z5; thread X24.2 Z-30 F2; rapid X30 Z-30; rapid X30 Z5; rapid X40 Z5)
