O1 (NUM-4: F100 and F100. are the same)
G90 G01 X1. F100 (expect moves: line X1 F100)
X2. F150. (expect moves: line X2 F150)
M30
