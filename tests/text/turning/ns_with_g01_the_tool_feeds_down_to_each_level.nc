(run with: --machine lathe2)
O1 (ns with G01: the tool feeds down to each level)
G97S500M03
G00X50.Z2.
G71U4.R1.
G71P10Q50U0.W0.F.3
N10G01X30.
G01Z-18.F.15
N50G01X50.Z-26.
M30
(finally moves: rapid X50 Z2; line X42 Z2; line X42 Z-22.8; rapid X44 Z-21.8; rapid X44 Z2; line X34 Z2; line X34 Z-19.6; rapid X36 Z-18.6; rapid X36 Z2; line X30 Z2; line X30 Z-18; rapid X32 Z-17; rapid X32 Z2; line X30 Z2; line X30 Z-18; line X50 Z-26; rapid X50 Z2)
(finally work X50 Z2)
