O1 (CYC-15: the words of the cycle are ignored)
G90 G00 Z10.
G81 G01 X1. Z-5. R2. F100 (expect moves: line X1 Z10)
M30
