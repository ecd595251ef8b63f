O1 (G-6)
G61 G00 X1. (expect moves: rapid X1 pass)
G28 X2. (expect moves: rapid X2 pass; rapid X0 pass)
G01 X3. F100 (expect moves: line X3 stop)
M30
