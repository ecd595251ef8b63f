O1 (section 10: K2)
G90 G00 Z10.
G99 G81 X1. Z-5. R2. K2 F100 (expect moves: rapid X1 Z10; rapid Z2; line Z-5; rapid Z2; line Z-5; rapid Z2)
G80
M30
