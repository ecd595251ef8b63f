O1 (G-6)
G01 X1. F100 (expect moves: line X1 pass)
G61 X2. (expect moves: line X2 stop)
G02 X3. R1. (expect moves: cw X3 stop)
G64 G01 X4. (expect moves: line X4 pass)
G61
X5. (expect moves: line X5 stop)
G62 X6. (expect moves: line X6 pass)
G61 X7. (expect moves: line X7 stop)
G63 X8. (expect moves: line X8 pass)
M30
