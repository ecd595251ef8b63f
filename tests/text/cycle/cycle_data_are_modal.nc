O1 (section 10: a new Z alone, then a new R alone)
G90 G00 Z10.
G99 G81 X1. Z-5. R2. F100
X2. Z-8. (expect moves: rapid X2 Z2; line Z-8; rapid Z2)
X3. R1. (expect moves: rapid X3 Z2; rapid Z1; line Z-8; rapid Z1)
G80
M30
