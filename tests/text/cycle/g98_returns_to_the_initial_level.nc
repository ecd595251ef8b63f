O1 (CYC-1: the level at which the cycle was entered)
G90 G00 Z50.
G98 G81 X1. Y0 Z-5. R2. F100 (expect moves: rapid X1 Z50; rapid Z2; line Z-5; rapid Z50)
X2. (expect moves: rapid X2 Z50; rapid Z2; line Z-5; rapid Z50)
G80
M30
