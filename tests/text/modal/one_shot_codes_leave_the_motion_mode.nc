O1 (G-1: G04 acts in its block only)
G01 F100
G04 P10
X1. (expect moves: line X1)
M30
