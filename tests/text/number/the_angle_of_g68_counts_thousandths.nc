O1 (NUM-3: R90000 turns by 90 degrees)
G68 X0 Y0 R90000
G90 G00 X10. Y0 (expect moves: rapid X0 Y10)
G69
M30
