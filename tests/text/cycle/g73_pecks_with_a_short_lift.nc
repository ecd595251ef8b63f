O1 (CYC-4: the golden sequence from 50)
G90 G00 Z50.
G98 G73 X0 Y0 Z-10. R2. Q4. F100
G80
M30
(finally moves: rapid Z50; rapid Z2; line Z-2 F100; rapid Z-1; line Z-6; rapid Z-5; line Z-10; rapid Z50)
