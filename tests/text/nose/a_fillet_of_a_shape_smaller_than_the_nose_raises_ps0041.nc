(run with: --machine lathe2 --param cycle_nose=1 --set #2901=1.2 --set #2301=3)
O1 (turning, nose radius: the alarm stands at the block of the shape)
G97 S500 M03
G00 X64. Z2. T0101
G42
G71 U6. R.5
G71 P10 Q50 U.4 W.1 F.3
N10 G00 X20.
G01 Z-12. F.15
G02 X22. Z-13. R1. (expect alarm PS0041)
N50 G01 X64.
M30
