(run with: --machine mill4)
O1 (NUM-3: G20 changes lengths, not degrees)
G20
G90 G00 X1. A90. (expect moves: rapid X25.4 A90)
M30
