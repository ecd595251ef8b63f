O1 (CYC-1: until G80)
G90 G00 Z10.
G99 G81 X1. Y1. Z-5. R2. F100
X2. (expect moves: rapid X2 Y1 Z2; line Z-5; rapid Z2)
G80
X3. (expect moves: rapid X3 Y1 Z2)
M30
(finally moves: rapid Z10; rapid X1 Y1 Z10; rapid Z2; line X1 Y1 Z-5; rapid Z2; rapid X2 Y1 Z2; line Z-5; rapid Z2; rapid X3 Y1 Z2)
