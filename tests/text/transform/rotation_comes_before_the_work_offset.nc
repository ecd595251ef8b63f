O1 (section 8.5: the origin of G54 is not turned)
#5221=100.
G68 X0 Y0 R90.
G90 G00 X10. Y0 (expect moves: rapid X100 Y10)
G69
M30
