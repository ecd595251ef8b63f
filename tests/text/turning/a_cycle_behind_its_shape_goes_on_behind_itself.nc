(run with: --machine lathe2)
O1 (turning, cycles along a shape: a shape that stands before its cycle)
G97 S500 M03
G00 X64. Z2.
#100=0
GOTO 100
N10 G00 X20.
G01 Z-12. F.15
N50 X64.
N100 G71 U3. R.5
G71 P10 Q50 U.4 W.1 F.3
#100=1
M30
(finally #100=1)
(finally machine X64 Z2)
