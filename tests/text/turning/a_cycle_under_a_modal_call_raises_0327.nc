(run with: --machine lathe2)
O1 (turning, cycles along a shape: each block of the shape would call)
G97 S500 M03
G00 X64. Z2.
G66 P2
G71 U3. R.5 (expect alarm PS0327 says modal macro call)
M30
O2
M99
