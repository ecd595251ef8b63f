O1 (G-7)
G63 G01 X1. F100 (expect assumed: feed hold)
X2. (expect moves: line X2 fixed pass)
G00 X3. (expect moves: rapid X3 free)
G64 G01 X4. (expect moves: line X4 free)
M30
