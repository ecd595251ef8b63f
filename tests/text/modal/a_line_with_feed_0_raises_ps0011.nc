O1 (G-2: F0 is no feed)
G01 X1. F100
X2. F0 (expect alarm PS0011)
M30
(finally moves: line X1)
