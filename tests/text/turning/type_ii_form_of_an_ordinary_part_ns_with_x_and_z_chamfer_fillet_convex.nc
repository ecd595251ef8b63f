(run with: --machine lathe2)
O1 (type II form of an ordinary part ns with X and Z: chamfer, fillet, convex arc)
G97S500M03
G00X50.Z2.
G71U4.R.5
G71P10Q50U.4W0F.3
N10G00X16.Z2.
G01Z0.F.15
G01X20.Z-2.
G01Z-14.
G02X28.Z-18.R4.
G01X36.
G03X44.Z-22.R4.
G01Z-30.
N50G01X50.
M30
(finally moves: rapid X50 Z2; rapid X50.4 Z2; rapid X42.4 Z2; line X42.4 Z-19.3542; ccw X44.4 Z-22 @-22,36.4 ZX; rapid X45.4 Z-22; rapid X45.4 Z2; rapid X34.4 Z2; line X34.4 Z-18; line X36.4 Z-18; ccw X42.4 Z-19.3542 @-22,36.4 ZX; rapid X43.4 Z-19.3542; rapid X43.4 Z2; rapid X26.4 Z2; line X26.4 Z-17.873; cw X28.4 Z-18 @-14,28.4 ZX; line X34.4 Z-18; rapid X35.4 Z-18; rapid X35.4 Z2; rapid X18.4 Z2; line X18.4 Z-1; line X20.4 Z-2; rapid X21.4 Z-2; rapid X21.4 Z2; rapid X16.4 Z2; line X16.4 Z0; line X18.4 Z-1; rapid X19.4 Z-1; rapid X50.4 Z-1; rapid X50.4 Z2; rapid X16.4 Z2; line X16.4 Z0; line X20.4 Z-2; line X20.4 Z-14; cw X28.4 Z-18 @-14,28.4 ZX; line X36.4 Z-18; ccw X44.4 Z-22 @-22,36.4 ZX; line X44.4 Z-30; line X50.4 Z-30; rapid X50 Z2)
(finally work X50 Z2)
