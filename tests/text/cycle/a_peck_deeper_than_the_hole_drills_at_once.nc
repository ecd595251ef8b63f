O1 (CYC-12: Q20. in a hole of 5)
G90 G00 Z10.
G99 G83 X0 Y0 Z-5. R0 Q20. F100 (expect moves: rapid Z0; line Z-5; rapid Z0)
G80
M30
