(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: an outer contour with tip 3)
G97 S500 M03
G00 X60. Z5. T0101
G42 G00 X20. Z2. (expect moves: rapid X20 Z1.2)
G01 Z-10. F.1 (expect moves: line X20 Z-10.6111)
G01 X30. Z-20. (expect moves: line X30 Z-20.6111)
G01 Z-27. (expect moves: line X30 Z-27.8)
G02 X36. Z-30. R3. (expect moves: cw X34.4 Z-30 @-27.8,34.4 ZX)
G01 X50. (expect moves: line X48.4 Z-30)
G40 G00 X60. Z5. (expect moves: rapid X60 Z5)
M30
