O1 (ARC-1: upper half circle about 5,0)
G90 G17 G02 X10. Y0 I5. F100 (expect moves: cw X10 Y0 @5,0 XY F100)
M30
