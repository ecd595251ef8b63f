O1 (G10-3: the motion mode stays)
G01 F100
G10 L2 P1 Z5.
X1. Z0 (expect moves: line X1 Z5)
M30
