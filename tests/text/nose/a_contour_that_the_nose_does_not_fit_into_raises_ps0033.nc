(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: line and arc have no common point beside them)
G97 S500 M03
G00 X64. Z2. T0101
G42 G01 X20. F.1
Z-20. (expect alarm PS0033)
G02 X22.56 Z-18.72 I0 K1.28
G01 X24. Z-15.
G40 G00 X64.
M30
