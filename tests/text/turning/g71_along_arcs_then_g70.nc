(run with: --machine lathe2)
O1 (G71 along arcs, then G70)
G97S500M03
G00X64.Z2.
G71U3.R.5
G71P10Q50U.5W.1F.3
N10G00X20.
G01Z-12.F.15
G02X28.Z-16.R4.
G01X44.
G03X52.Z-20.R4.
G01Z-40.
N50G01X64.
G70P10Q50
M30
(finally moves: rapid X64 Z2; rapid X64.5 Z2.1; rapid X58.5 Z2.1; line X58.5 Z-39.9; rapid X59.5 Z-39.4; rapid X59.5 Z2.1; rapid X52.5 Z2.1; line X52.5 Z-39.9; rapid X53.5 Z-39.4; rapid X53.5 Z2.1; rapid X46.5 Z2.1; line X46.5 Z-16.027; rapid X47.5 Z-15.527; rapid X47.5 Z2.1; rapid X40.5 Z2.1; line X40.5 Z-15.9; rapid X41.5 Z-15.4; rapid X41.5 Z2.1; rapid X34.5 Z2.1; line X34.5 Z-15.9; rapid X35.5 Z-15.4; rapid X35.5 Z2.1; rapid X28.5 Z2.1; line X28.5 Z-15.9; rapid X29.5 Z-15.4; rapid X29.5 Z2.1; rapid X22.5 Z2.1; line X22.5 Z-14.5458; rapid X23.5 Z-14.0458; rapid X23.5 Z2.1; rapid X20.5 Z2.1; line X20.5 Z-11.9; rapid X21.5 Z-11.4; rapid X21.5 Z2.1; rapid X20.5 Z2.1; line X20.5 Z-11.9; cw X28.5 Z-15.9 @-11.9,28.5 ZX; line X44.5 Z-15.9; ccw X52.5 Z-19.9 @-19.9,44.5 ZX; line X52.5 Z-39.9; line X64.5 Z-39.9; rapid X64 Z2; rapid X20 Z2; line X20 Z-12; cw X28 Z-16 @-12,28 ZX; line X44 Z-16; ccw X52 Z-20 @-20,44 ZX; line X52 Z-40; line X64 Z-40; rapid X64 Z2)
(finally work X64 Z2)
