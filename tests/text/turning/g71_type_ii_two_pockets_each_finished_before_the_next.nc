(run with: --machine lathe2)
O1 (G71 type II: two pockets, each finished before the next)
G97S500M03
G00X50.Z2.
G71U2.R.5
G71P10Q50U0.W0F.3
N10G00X30.Z2.
G01Z-10.F.15
G01X20.Z-15.
G01Z-25.
G01X32.Z-30.
G01Z-40.
G01X24.Z-44.
G01Z-50.
G01X40.Z-55.
N50G01X46.Z-60.
M30
(finally moves: rapid X50 Z2; rapid X46 Z2; line X46 Z-60; line X50 Z-60; rapid X51 Z-60; rapid X51 Z2; rapid X42 Z2; line X42 Z-56.6667; line X46 Z-60; rapid X47 Z-60; rapid X47 Z2; rapid X38 Z2; line X38 Z-54.375; line X40 Z-55; line X42 Z-56.6667; rapid X43 Z-56.6667; rapid X43 Z2; rapid X34 Z2; line X34 Z-53.125; line X38 Z-54.375; rapid X39 Z-54.375; rapid X39 Z2; rapid X30 Z2; line X30 Z-29.1667; line X32 Z-30; rapid X33 Z-30; rapid X33 Z-10; line X30 Z-10; line X26 Z-12; line X26 Z-27.5; line X30 Z-29.1667; rapid X31 Z-29.1667; rapid X31 Z-12; line X26 Z-12; line X22 Z-14; line X22 Z-25.8333; line X26 Z-27.5; rapid X27 Z-27.5; rapid X27 Z-14; line X22 Z-14; line X20 Z-15; line X20 Z-25; line X22 Z-25.8333; rapid X23 Z-25.8333; rapid X35 Z-25.8333; rapid X35 Z-40; line X32 Z-40; line X30 Z-41; line X30 Z-51.875; line X34 Z-53.125; rapid X35 Z-53.125; rapid X35 Z-41; line X30 Z-41; line X26 Z-43; line X26 Z-50.625; line X30 Z-51.875; rapid X31 Z-51.875; rapid X31 Z-43; line X26 Z-43; line X24 Z-44; line X24 Z-50; line X26 Z-50.625; rapid X27 Z-50.625; rapid X50 Z-50.625; rapid X50 Z2; rapid X30 Z2; line X30 Z-10; line X20 Z-15; line X20 Z-25; line X32 Z-30; line X32 Z-40; line X24 Z-44; line X24 Z-50; line X40 Z-55; line X46 Z-60; rapid X50 Z2)
(finally work X50 Z2)
