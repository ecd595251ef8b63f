O1 (section 8: F comes before the motion)
G01 X1. F100
F200 X2. (expect moves: line X2 F200)
M30
