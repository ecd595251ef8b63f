O1 (WCS-1: the next absolute move is in the new system)
#5241=10.
G55 (expect moves: none)
G90 G00 X1. (expect moves: rapid X11)
M30
