O1 (ARC-1: lower half circle)
G90 G03 X10. Y0 I5. F100 (expect moves: ccw X10 Y0 @5,0 XY)
M30
