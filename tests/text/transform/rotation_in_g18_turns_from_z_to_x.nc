O1 (G68: positive from the first to the second axis of the plane)
G18 G68 X0 Z0 R90.
G90 G00 Z10. X0 (expect moves: rapid X10 Z0)
G69
M30
