(run with: --machine lathe2 --param cycle_nose=1 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: G72 outside towards the face has the tool on the left)
G97 S500 M03
G00 X64. Z2. T0101
G41
G72 W4. R.5
G72 P10 Q30 U0 W0 F.3
N10 G00 Z-8. (expect moves: rapid X64 Z-8; rapid X62.4 Z-8)
G01 X40. F.1 (expect moves: line X39.0627 Z-8)
X28. Z-2. (expect moves: line X27.0627 Z-2)
N30 X20. (expect moves: line X18.4 Z-2)
M30
