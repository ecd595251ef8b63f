(run with: --machine lathe2)
O1 (turning, cycles along a shape: the tool would go into the work)
G97 S500 M03
G00 X64. Z2.
G71 U3. R-.5 (expect alarm PS0006 at R-.5)
G71 P10 Q50 F.3
N10 G00 X20.
G01 Z-12. F.15
N50 X64.
M30
