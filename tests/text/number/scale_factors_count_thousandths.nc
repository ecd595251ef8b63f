O1 (NUM-10: P2500 is two and a half)
G51 X0 Y0 P2500
G90 G00 X2. Y4. (expect moves: rapid X5 Y10)
G50
M30
