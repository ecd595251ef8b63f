(run with: --machine lathe2)
O1 (turning, cycles along a shape: F of the shape acts in G70 alone)
G97 S500 M03
G00 X64. Z2.
G71 U3. R.5
G71 P10 Q50 (expect alarm PS0011)
N10 G00 X20.
G01 Z-12. F.15
N50 X64.
M30
