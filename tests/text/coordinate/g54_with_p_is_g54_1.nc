O1 (WCS-2: the point one may be left out)
#7021=5.
G54 P2
G90 G00 X0 (expect moves: rapid X5)
M30
