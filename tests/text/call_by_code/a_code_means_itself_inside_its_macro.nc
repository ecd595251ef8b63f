(run with: --param 6050=81)
O1 (CODE-1: G81 in O9010 is the drilling cycle)
G90 G00 Z10.
G81 X1. Z-5. R2. F100
M30
O9010
G99 G81 X#24 Y0 Z#26 R#18 F#9 (expect moves: rapid X1 Z10; rapid Z2; line Z-5 F100; rapid Z2)
G80
M99
