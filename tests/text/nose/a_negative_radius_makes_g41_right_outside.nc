(run with: --machine lathe2 --param cycle_nose=1 --set #2901=-0.8 --set #2301=3)
O1 (turning, nose radius: a radius below 0 swaps the sides, also of a shape)
G97 S500 M03
G00 X30. Z2. T0101
G41
G71 U5. R.5
G71 P10 Q20 U0 W0 F.3
N10 G00 X20. (expect moves: rapid X20 Z2; rapid X20 Z1.2)
G01 Z-12. F.15 (expect moves: line X20 Z-12)
N20 X30. Z-12. F.15 (expect moves: line X28.4 Z-12)
G40
M30
