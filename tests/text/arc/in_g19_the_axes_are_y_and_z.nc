O1 (section 8.2: J and K)
G90 G00 Y10.
G19 G03 Y0 Z10. J-10. K0 F100 (expect moves: ccw Y0 Z10 @0,0 YZ)
M30
