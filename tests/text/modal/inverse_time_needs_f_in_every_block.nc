O1 (G93: the second line has none)
G93 G01 X1. F2. (expect moves: line X1)
X2. (expect alarm PS1202)
M30
