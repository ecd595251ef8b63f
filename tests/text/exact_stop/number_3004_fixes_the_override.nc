O1 (G-7)
G01 X1. F100 (expect moves: line X1 free)
#3004=2
X2. (expect moves: line X2 fixed)
G00 X3. (expect moves: rapid X3 free)
#3004=#0
G01 X4. (expect moves: line X4 free)
M30
(finally assumed: none)
