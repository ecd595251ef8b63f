(run with: --machine lathe2 --param cycle_nose=1 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: the shape is the path of the tip; the levels end on it)
G97 S500 M03
G00 X64. Z2. T0101
G42
G71 U6. R.5 (expect moves: none)
G71 P10 Q50 U.4 W.1 F.3
N10 G00 X20. (expect moves: rapid X20.4 Z2.1; rapid X20.4 Z1.3)
G01 Z-12. F.15 (expect moves: line X20.4 Z-12.3686)
X28. Z-16. (expect moves: line X27.4627 Z-15.9)
X44. (expect moves: line X42.8 Z-15.9)
G03 X52. Z-20. R4. (expect moves: ccw X52.4 Z-20.7 @-20.7,42.8)
G01 Z-40. (expect moves: line X52.4 Z-39.9)
N50 X64. (expect moves: line X62.8 Z-39.9)
G40
M30
(finally moves: rapid X64 Z2; rapid X64.4 Z2.1; rapid X52.4 Z2.1; line X52.4 Z-39.9; rapid X53.4 Z-39.4; rapid X53.4 Z2.1; rapid X40.4 Z2.1; line X40.4 Z-15.9; rapid X41.4 Z-15.4; rapid X41.4 Z2.1; rapid X28.4 Z2.1; line X28.4 Z-15.9; rapid X29.4 Z-15.4; rapid X29.4 Z2.1; rapid X20.4 Z2.1; line X20.4 Z-12.3686; rapid X21.4 Z-11.8686; rapid X21.4 Z2.1; rapid X20.4 Z2.1; rapid X20.4 Z1.3; line X20.4 Z-12.3686; line X27.4627 Z-15.9; line X42.8 Z-15.9; ccw X52.4 Z-20.7 @-20.7,42.8; line X52.4 Z-39.9; line X62.8 Z-39.9; rapid X64 Z2)
(finally assumed: none)
