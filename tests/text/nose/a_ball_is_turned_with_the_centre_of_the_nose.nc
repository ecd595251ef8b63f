(run with: --machine lathe2 --set #2901=3 --set #2301=9)
O1 (turning, nose radius: the centre is programmed with tip 9)
G97 S500 M03
G00 X50. Z10. T0101
G42 G00 X0 Z8. (expect moves: rapid X6 Z8)
G01 Z0. F.1 (expect moves: line X6 Z2.7482)
G03 X30. Z-15. R15. (expect moves: ccw X36 Z-15 @-15,0 ZX)
G01 Z-25. (expect moves: line X36 Z-25)
G40 G00 X50. Z10.
M30
