O1 (WCS-4: no motion, then X1. is one away)
G90 G00 X5.
G92 X0 (expect moves: none)
#100=#5001 (expect #100=0)
G00 X1. (expect moves: rapid X6)
#101=#5001 (expect #101=1)
#102=#5021 (expect #102=6)
M30
