O1 (section 8.2: centre in machine coordinates)
#5221=100.
G90 G00 X0 Y0
G02 X10. Y0 I5. F100 (expect moves: cw X110 Y0 @105,0)
M30
