(run with: --machine lathe2 --param cycle_nose=1 --set #2901=0.4 --set #2301=2)
O1 (turning, nose radius: the tool would be inside of the shape)
G97 S500 M03
G00 X18. Z2. T0101
G42
G71 U2. R.5
G71 P10 Q50 U-.4 W.1 F.3 (expect alarm PS0328)
N10 G00 X50.
G01 Z-10. F.15
N50 X18.
M30
