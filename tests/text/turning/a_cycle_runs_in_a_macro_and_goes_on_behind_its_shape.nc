(run with: --machine lathe2)
O1 (turning, cycles along a shape: the program that runs is searched)
G97 S500 M03
G00 X64. Z2.
G65 P2
#101=1
M30
O2
G71 U3. R.5
G71 P10 Q50 U.4 W.1 F.3
N10 G00 X20.
G01 Z-12. F.15
N50 X64.
#100=1 (expect #100=1)
G70 P10 Q50
M99
(finally #100=1, #101=1)
(finally machine X64 Z2)
