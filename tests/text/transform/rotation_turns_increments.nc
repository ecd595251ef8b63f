O1 (G68: along the turned axis)
G90 G00 X0 Y0
G68 X0 Y0 R90.
G91 X10. (expect moves: rapid X0 Y10)
X10. (expect moves: rapid X0 Y20)
G69
M30
