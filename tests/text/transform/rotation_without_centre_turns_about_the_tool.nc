O1 (G68: the current position is the centre)
G90 G00 X10.
G68 R90.
X20. Y0 (expect moves: rapid X10 Y10)
G69
M30
