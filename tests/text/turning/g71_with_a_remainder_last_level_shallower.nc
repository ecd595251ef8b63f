(run with: --machine lathe2)
O1 (G71 with a remainder: last level shallower)
G97S500M03
G00X90.Z3.
G71U4.R.8
G71P10Q50U.6W.2F.3
N10G00X36.
G01Z-15.F.15
G01X50.Z-30.
G01Z-45.
N50G01X90.
M30
(finally moves: rapid X90 Z3; rapid X90.6 Z3.2; rapid X82.6 Z3.2; line X82.6 Z-44.8; rapid X84.2 Z-44; rapid X84.2 Z3.2; rapid X74.6 Z3.2; line X74.6 Z-44.8; rapid X76.2 Z-44; rapid X76.2 Z3.2; rapid X66.6 Z3.2; line X66.6 Z-44.8; rapid X68.2 Z-44; rapid X68.2 Z3.2; rapid X58.6 Z3.2; line X58.6 Z-44.8; rapid X60.2 Z-44; rapid X60.2 Z3.2; rapid X50.6 Z3.2; line X50.6 Z-44.8; rapid X52.2 Z-44; rapid X52.2 Z3.2; rapid X42.6 Z3.2; line X42.6 Z-21.2286; rapid X44.2 Z-20.4286; rapid X44.2 Z3.2; rapid X36.6 Z3.2; line X36.6 Z-14.8; rapid X38.2 Z-14; rapid X38.2 Z3.2; rapid X36.6 Z3.2; line X36.6 Z-14.8; line X50.6 Z-29.8; line X50.6 Z-44.8; line X90.6 Z-44.8; rapid X90 Z3)
(finally work X90 Z3)
