(run with: --machine lathe2 --param cycle_nose=1 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: the way to A has no offset, and the next move has it again)
G97 S500 M03
G00 X50. Z12. T0101
G42 X40. Z2.
X40. Z1.
G71 U10. R.5
G71 P10 Q20 U0 W0 F.3
N10 G00 X20.
N20 G01 Z-10. F.1
G01 X30. F.1 (expect moves: line X30 Z0.2)
Z-5. (expect moves: line X30 Z-5.8)
G40 G00 X50.
M30
(finally machine X50 Z-5)
