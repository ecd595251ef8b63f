O1 (section 10: the repeat address of older controls)
G90 G00 Z10.
G99 G81 X1. Y0 Z-5. R1. F100 L0 (expect moves: none)
G91 X2. L2 (expect moves: rapid X2 Z10; rapid Z1; line Z-5; rapid Z1; rapid X4 Z1; line Z-5; rapid Z1)
G80
M30
