O1 (ARC-5: within the tolerance of 0.010)
G02 X10. Y0 R4.997 F100 (expect moves: cw X10 Y0 @5,0)
M30
