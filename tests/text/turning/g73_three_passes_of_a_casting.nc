(run with: --machine lathe2)
O1 (G73: three passes of a casting)
G97S500M03
G00X80.Z6.
G73U8.W4.R3
G73P10Q50U.8W.3F.3
N10G00X30.Z2.
G01Z-14.F.15
G02X42.Z-20.R6.
N50G01X60.Z-26.
M30
(finally moves: rapid X80 Z6; rapid X96.8 Z10.3; rapid X46.8 Z6.3; line X46.8 Z-9.7; cw X58.8 Z-15.7 @-9.7,58.8 ZX; line X76.8 Z-21.7; rapid X88.8 Z8.3; rapid X38.8 Z4.3; line X38.8 Z-11.7; cw X50.8 Z-17.7 @-11.7,50.8 ZX; line X68.8 Z-23.7; rapid X80.8 Z6.3; rapid X30.8 Z2.3; line X30.8 Z-13.7; cw X42.8 Z-19.7 @-13.7,42.8 ZX; line X60.8 Z-25.7; rapid X80 Z6)
