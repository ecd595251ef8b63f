(run with: --machine lathe2)
O1 (turning, cycles along a shape: PS0061)
G97 S500 M03
G00 X64. Z2.
G70 Q50 (expect alarm PS0061 says P is missing)
N10 G00 X20.
G01 Z-12. F.15
N50 X64.
M30
