O1 (G-6)
G09 G01 X1. F100 (expect moves: line X1 stop)
X2. (expect moves: line X2 pass)
G09 G03 X3. R1. (expect moves: ccw X3 stop)
G09 G00 X4. (expect moves: rapid X4 stop)
G01 X5. (expect moves: line X5 pass)
M30
(finally assumed: none)
