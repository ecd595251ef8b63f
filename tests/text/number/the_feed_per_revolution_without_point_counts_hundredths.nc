O1 (NUM-5: F20 in G95 is 0.2 mm a revolution)
S1000 M03
G95
G90 G01 Z-1. F20 (expect moves: line Z-1 F0.2)
Z-2. F0.3 (expect moves: line Z-2 F0.3)
M30
