O1 (CYC-12: 3, 3 and 1)
G90 G00 Z10.
G99 G73 X0 Y0 Z-7. R0 Q3. F100 (expect moves: rapid Z0; line Z-3; rapid Z-2; line Z-6; rapid Z-5; line Z-7; rapid Z0)
G80
M30
