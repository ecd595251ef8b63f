(run with: --machine lathe2)
O1 (G71 on the other side of the centre line X negative)
G97S500M03
G00X-60.Z2.
G71U3.R.5
G71P10Q50U-.4W.1F.3
N10G00X-24.
G01Z-14.F.15
G01X-40.Z-22.
N50G01X-60.
M30
(finally moves: rapid X-60 Z2; rapid X-60.4 Z2.1; rapid X-54.4 Z2.1; line X-54.4 Z-21.9; rapid X-55.4 Z-21.4; rapid X-55.4 Z2.1; rapid X-48.4 Z2.1; line X-48.4 Z-21.9; rapid X-49.4 Z-21.4; rapid X-49.4 Z2.1; rapid X-42.4 Z2.1; line X-42.4 Z-21.9; rapid X-43.4 Z-21.4; rapid X-43.4 Z2.1; rapid X-36.4 Z2.1; line X-36.4 Z-19.9; rapid X-37.4 Z-19.4; rapid X-37.4 Z2.1; rapid X-30.4 Z2.1; line X-30.4 Z-16.9; rapid X-31.4 Z-16.4; rapid X-31.4 Z2.1; rapid X-24.4 Z2.1; line X-24.4 Z-13.9; rapid X-25.4 Z-13.4; rapid X-25.4 Z2.1; rapid X-24.4 Z2.1; line X-24.4 Z-13.9; line X-40.4 Z-21.9; line X-60.4 Z-21.9; rapid X-60 Z2)
(finally work X-60 Z2)
