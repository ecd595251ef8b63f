O1 (G51.1: the rotation behind one mirrored axis turns clockwise)
G51.1 X0
G68 X0 Y0 R90.
G90 G00 X10. Y0 (expect moves: rapid X0 Y10)
G69
G50.1 X0
M30
