(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: no chamfer where the compensation begins)
G00 X60. Z5. T0101
G42 G01 X20. Z2.,C1. F.1 (expect alarm PS0039)
Z-10.
M30
