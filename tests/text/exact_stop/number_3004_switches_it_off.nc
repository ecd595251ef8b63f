O1 (G-6)
#3004=4
G61 G01 X1. F100 (expect moves: line X1 pass)
G09 X2. (expect moves: line X2 pass)
G60 X3. (expect moves: rapid X3 pass)
#3004=3 (expect assumed: feed hold)
G01 X4. (expect moves: line X4 stop)
M30
