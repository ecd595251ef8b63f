O1 (G10-3: G10 moves nothing)
G90 G00 X5.
G10 L2 P1 X10. (expect moves: none)
X5. (expect moves: rapid X15)
M30
