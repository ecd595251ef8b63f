O1 (section 8: G55 acts in its own block)
#5241=10.
G90 G00 X1. G55 (expect moves: rapid X11)
M30
