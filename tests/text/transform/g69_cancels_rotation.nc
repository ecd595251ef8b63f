O1 (G68: the next absolute move is straight)
G68 X0 Y0 R90.
G90 G00 X10. Y0
G69
X10. Y0 (expect moves: rapid X10 Y0)
M30
