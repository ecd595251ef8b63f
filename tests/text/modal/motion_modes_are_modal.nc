O1 (section 8.1: G00 and G01 stay on)
G01 X1. F100
X2. (expect moves: line X2 F100)
G00 X3.
X4. (expect moves: rapid X4)
M30
