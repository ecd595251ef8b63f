(run with: --machine lathe2 --param LGN=1 --set #2905=.8 --set #2205=.3 --set #2202=.2 --set #2302=3)
O1 (turning, nose radius: with LGN the radius of geometry has the number of the tool)
G00 X60. Z5. T0502
G42 G00 X20. Z2. (expect moves: rapid X20 Z1)
G01 Z-10. F.1
G40 G00 X60.
M30
