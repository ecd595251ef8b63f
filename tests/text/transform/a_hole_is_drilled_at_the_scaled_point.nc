O1 (G51: X is doubled, the peck Q and its clearance are not)
G90 G00 Z10.
G51 X0 Y0 Z0 I2000 J2000 K1000
G99 G73 X3. Y0 Z-8. R0 Q4. F100 (expect moves: rapid X6 Z10; rapid Z0; line Z-4; rapid Z-3; line Z-8; rapid Z0)
G80
G50
M30
