O1 (CYC-14: R, R and then the initial level)
G90 G00 Z10.
G99 G81 X0 Y0 Z-5. R2. F100 (expect moves: rapid Z2; line Z-5; rapid Z2)
X10. (expect moves: rapid X10 Z2; line Z-5; rapid Z2)
G98 X20. (expect moves: rapid X20 Z2; line Z-5; rapid Z10)
G80
M30
