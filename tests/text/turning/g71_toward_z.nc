(run with: --machine lathe2)
O1 (G71 toward +Z)
G97S500M03
G00X70.Z-82.
G71U5.R1.
G71P10Q50U.5W-.2F.3
N10G00X30.
G01Z-60.F.15
G01X46.Z-48.
N50G01X70.
M30
(finally moves: rapid X70 Z-82; rapid X70.5 Z-82.2; rapid X60.5 Z-82.2; line X60.5 Z-48.2; rapid X62.5 Z-49.2; rapid X62.5 Z-82.2; rapid X50.5 Z-82.2; line X50.5 Z-48.2; rapid X52.5 Z-49.2; rapid X52.5 Z-82.2; rapid X40.5 Z-82.2; line X40.5 Z-52.7; rapid X42.5 Z-53.7; rapid X42.5 Z-82.2; rapid X30.5 Z-82.2; line X30.5 Z-60.2; rapid X32.5 Z-61.2; rapid X32.5 Z-82.2; rapid X30.5 Z-82.2; line X30.5 Z-60.2; line X46.5 Z-48.2; line X70.5 Z-48.2; rapid X70 Z-82)
(finally work X70 Z-82)
