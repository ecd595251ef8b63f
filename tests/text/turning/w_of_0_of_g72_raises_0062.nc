(run with: --machine lathe2)
O1 (turning, cycles along a shape: PS0062)
G97 S500 M03
G00 X64. Z2.
G72 W0 R.5 (expect alarm PS0062)
G72 P10 Q50 F.3
N10 G00 X20.
G01 Z-12. F.15
N50 X64.
M30
