O1 (G51: the next absolute move is unscaled)
G51 X0 Y0 P2000
G90 G00 X3. (expect moves: rapid X6)
G50
X4. (expect moves: rapid X4)
M30
