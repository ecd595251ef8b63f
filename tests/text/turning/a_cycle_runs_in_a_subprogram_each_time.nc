(run with: --machine lathe2)
O1 (turning, cycles along a shape: a subprogram that repeats)
G97 S500 M03
G00 X64. Z2.
M98 P20002
M30
O2
#100=#100+1
G71 U30. R.5
G71 P10 Q50 U0 W0 F.3
N10 G00 X20.
G01 Z-12. F.15
N50 X64.
M99
(finally #100=2)
(finally moves: rapid X64 Z2; rapid X20 Z2; line X20 Z-12; rapid X21 Z-11.5; rapid X21 Z2; rapid X20 Z2; line X20 Z-12; line X64 Z-12; rapid X64 Z2; rapid X20 Z2; line X20 Z-12; rapid X21 Z-11.5; rapid X21 Z2; rapid X20 Z2; line X20 Z-12; line X64 Z-12; rapid X64 Z2)
