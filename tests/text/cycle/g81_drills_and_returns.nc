O1 (CYC-1: to R and back to R)
G90 G00 Z10.
G99 G81 X1. Y2. Z-5. R2. F100 (expect moves: rapid X1 Y2 Z10; rapid Z2; line X1 Y2 Z-5 F100; rapid Z2)
G80
M30
