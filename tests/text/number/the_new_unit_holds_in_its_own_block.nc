O1 (NUM-18: X1. beside G20 is an inch)
G20 G90 G00 X1. (expect moves: rapid X25.4)
G21 X1. (expect moves: rapid X1)
M30
