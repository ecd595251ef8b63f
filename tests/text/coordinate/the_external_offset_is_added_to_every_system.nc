O1 (section 8.3: EXT)
#5201=5.
G90 G00 X1. (expect moves: rapid X6)
G55 X2. (expect moves: rapid X7)
M30
