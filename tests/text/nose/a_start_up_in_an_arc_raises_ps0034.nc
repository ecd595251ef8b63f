(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: compensation cannot begin with an arc)
G97 S500 M03
G00 X40. Z5. T0101
G42 G02 X30. Z0 R5. F.1 (expect alarm PS0034)
G01 Z-10.
M30
(finally machine X40 Z5)
