(run with: --machine lathe2)
O1 (turning, cycles along a shape: macro statements run)
G97 S500 M03
G00 X64. Z2.
G71 U3. R.5
G71 P10 Q50 U.4 W.1 F.3
N10 G00 X20.
G01 Z-12. F.15
GOTO 99
N50 X64.
N99 M30
(finally machine X64 Z2)
