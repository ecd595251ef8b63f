O1 (section 8.1: G09, G61 and G64)
G09 G01 X1. F100 (expect moves: line X1)
G61 X2. (expect moves: line X2)
G64 X3. (expect moves: line X3)
M30
(finally assumed: none)
