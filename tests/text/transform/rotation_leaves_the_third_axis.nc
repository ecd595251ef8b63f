O1 (G68: Z is not turned)
G68 X0 Y0 R90.
G90 G00 X10. Y0 Z7. (expect moves: rapid X0 Y10 Z7)
G69
M30
