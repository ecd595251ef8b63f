(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: the path on its floor would run backwards)
G00 X50. Z5. T0101
G42 G00 X40. Z2.
G01 Z-10. F.1
X30.
Z-11. (expect alarm PS0041)
X40.
Z-20.
M30
