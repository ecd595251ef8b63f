(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: PS0038)
G97 S500 M03
G00 X64. Z2. T0101
G42 G01 X20. F.1
Z-10.
G02 Z-10.005 K-.005 (expect alarm PS0038)
G40 G00 X64.
M30
