O1 (NUM-10: I1500 is one and a half, J2000 is two)
G51 X0 Y0 I1500 J2000 K1000
G90 G00 X2. Y4. (expect moves: rapid X3 Y8)
G50
M30
