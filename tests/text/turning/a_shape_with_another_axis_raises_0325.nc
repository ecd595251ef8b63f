(run with: --machine lathe3c)
O1 (turning, cycles along a shape: a shape lies in X and Z)
G97 S500 M03
G00 X64. Z2.
G71 U3. R.5
G71 P10 Q50 U.4 W.1 F.3
N10 G00 X20.
G01 C10. F.1 (expect alarm PS0325 at C10.)
N50 X64.
M30
