(run with: --machine lathe2)
O1 (G72: levels in Z)
G97S500M03
G00X84.Z2.
G72W4.R.5
G72P10Q50U.4W.2F.25
N10G00Z-24.
G01X60.F.15
G01X44.Z-12.
G01X30.
N50G01Z-1.
M30
(finally moves: rapid X84 Z2; rapid X84.4 Z2.2; rapid X84.4 Z-1.8; line X30.4 Z-1.8; rapid X31.4 Z-1.3; rapid X84.4 Z-1.3; rapid X84.4 Z-5.8; line X30.4 Z-5.8; rapid X31.4 Z-5.3; rapid X84.4 Z-5.3; rapid X84.4 Z-9.8; line X30.4 Z-9.8; rapid X31.4 Z-9.3; rapid X84.4 Z-9.3; rapid X84.4 Z-13.8; line X47.0667 Z-13.8; rapid X48.0667 Z-13.3; rapid X84.4 Z-13.3; rapid X84.4 Z-17.8; line X52.4 Z-17.8; rapid X53.4 Z-17.3; rapid X84.4 Z-17.3; rapid X84.4 Z-21.8; line X57.7333 Z-21.8; rapid X58.7333 Z-21.3; rapid X84.4 Z-21.3; rapid X84.4 Z-23.8; line X60.4 Z-23.8; rapid X61.4 Z-23.3; rapid X84.4 Z-23.3; rapid X84.4 Z-23.8; line X60.4 Z-23.8; line X44.4 Z-11.8; line X30.4 Z-11.8; line X30.4 Z-0.8; rapid X84 Z2)
