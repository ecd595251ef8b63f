O1 (CYC-16: F50 acts)
G90 G00 Z10.
G99 G81 X1. Z-5. R2. F100
F50 (expect moves: none)
X2. (expect moves: rapid X2; line Z-5 F50; rapid Z2)
G80
M30
