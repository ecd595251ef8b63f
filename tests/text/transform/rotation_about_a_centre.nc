O1 (G68: a and b)
G68 X10. Y0 R90.
G90 G00 X20. Y0 (expect moves: rapid X10 Y10)
G69
M30
