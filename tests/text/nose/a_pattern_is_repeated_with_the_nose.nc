(run with: --machine lathe2 --param cycle_nose=1 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: G73 makes the path of the tip in each pass)
G97 S500 M03
G00 X80. Z6. T0101
G42
G73 U4. W0 R2
G73 P10 Q50 U.8 W0 F.3
N10 G00 X30. Z2. (expect moves: rapid X30.8 Z1.2)
G01 Z-14. F.15 (expect moves: line X30.8 Z-14.8)
G02 X42. Z-20. R6. (expect moves: cw X41.2 Z-20 @-14.8,41.2)
N50 G01 X60. (expect moves: line X59.2 Z-20)
M30
(finally moves: rapid X80 Z6; rapid X88.8 Z6; rapid X38.8 Z1.2; line X38.8 Z-14.8; cw X49.2 Z-20 @-14.8,49.2; line X67.2 Z-20; rapid X80.8 Z6; rapid X30.8 Z1.2; line X30.8 Z-14.8; cw X41.2 Z-20 @-14.8,41.2; line X59.2 Z-20; rapid X80 Z6)
