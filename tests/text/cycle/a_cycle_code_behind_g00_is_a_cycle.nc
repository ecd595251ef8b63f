O1 (CYC-15: the last code of the block decides)
G90 G00 Z10.
G99 G00 G81 X1. Z-5. R2. F100 (expect moves: rapid X1 Z10; rapid Z2; line Z-5; rapid Z2)
G80
M30
