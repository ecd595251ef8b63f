(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: the plane is that of Z and X)
G00 X50. Z5. T0101
G42 G00 X40. Z2.
G17 (expect alarm PS0037)
M30
