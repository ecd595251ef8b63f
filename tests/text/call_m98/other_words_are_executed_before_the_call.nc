O1 (CALL-2: the move of the block comes first)
G00 X1. M98 P2 (expect moves: rapid X1)
M30
O2
#100=#5001 (expect #100=1)
G00 X2.
M99
(finally moves: rapid X1; rapid X2)
