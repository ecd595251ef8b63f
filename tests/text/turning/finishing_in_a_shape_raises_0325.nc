(run with: --machine lathe2)
O1 (turning, cycles along a shape: cycles are not nested)
G97 S500 M03
G00 X64. Z2.
G71 U3. R.5
G71 P10 Q50 U.4 W.1 F.3
N10 G00 X20.
G70 P60 Q70 (expect alarm PS0325 at G70)
N50 X64.
N60 G00 X30.
N70 G01 Z-3.
M30
