(run with: --machine lathe2 --set #2901=0.4 --set #2301=2)
O1 (turning, nose radius: an inner contour with tip 2)
G97 S500 M03
G00 X16. Z4. T0101
G41 G00 X40. Z1. (expect moves: rapid X40.2343 Z0.8828)
G01 X32. Z-3. F.1 (expect moves: line X32 Z-3.2343)
G01 Z-15. (expect moves: line X32 Z-15.4)
G03 X26. Z-18. R3. (expect moves: ccw X26.8 Z-18 @-15.4,26.8 ZX)
G01 X18. (expect moves: line X18.8 Z-18)
G40 G00 X16. Z4. (expect moves: rapid X16 Z4)
M30
