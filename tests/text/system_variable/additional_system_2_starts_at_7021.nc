O1 (section 3.4: #7021 is X of G54.1 P2)
#7021=5.
G54.1 P2
G90 G00 X0 (expect moves: rapid X5)
M30
