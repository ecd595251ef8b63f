(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: G42 and G40 in the shape of G70)
G97 S500 M03
G00 X60. Z5. T0101
G70 P10 Q20
M30
N10 G00 G42 X20. Z2.
G01 Z-10. F.1
X40. Z-20.
N20 G40 X60.
M30
(finally moves: rapid X60 Z5; rapid X20 Z1.2; line X20 Z-10.4686; line X39.5314 Z-20.2343; line X60 Z-20; rapid X60 Z5)
