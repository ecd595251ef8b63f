O1 (LEX-27: Q-4. pecks like Q4.)
G90 G00 Z10.
G99 G73 X0 Y0 Z-8. R0 Q-4. F100 (expect moves: rapid Z0; line Z-4; rapid Z-3; line Z-8; rapid Z0)
G80
M30
