(run with: --machine lathe2 --param cycle_nose=1 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: with cycle_nose = 1 G40 to G42 stand before the cycle)
G97 S500 M03
G00 X64. Z2. T0101
G71 U6. R.5
G71 P10 Q20 U.4 W.1 F.3
N10 G00 G42 X20. (expect alarm PS0325 at G42)
N20 G01 Z-12. F.15
M30
