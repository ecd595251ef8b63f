(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: G42 of the shape is told)
G97 S500 M03
G00 X40. Z2. T0101

G71 U5. R.5
G71 P10 Q20 U0 W0 F.3
N10 G00 G42 X20. (expect assumed: do not compensate the nose radius)
G01 Z-10. F.1
N20 X40. Z-20.

M30
(finally moves: rapid X40 Z2; rapid X30 Z2; line X30 Z-15; rapid X31 Z-14.5; rapid X31 Z2; rapid X20 Z2; line X20 Z-10; rapid X21 Z-9.5; rapid X21 Z2; rapid X20 Z2; line X20 Z-10; line X40 Z-20; rapid X40 Z2)
