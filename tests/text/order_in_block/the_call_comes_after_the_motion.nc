O1 (section 8: M98 is among the last)
M98 P2 G90 G00 X1. (expect moves: rapid X1)
M30
O2
X2.
M99
(finally moves: rapid X1; rapid X2)
