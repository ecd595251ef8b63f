O1 (section 10: one hole at X2.)
G90 G00 Z10.
G99 G81 X1. Y0 Z-5. R1. F100 K0 (expect moves: none)
X2. (expect moves: rapid X2 Z10; rapid Z1; line X2 Z-5; rapid Z1)
G80
M30
