O1 (ARC-5: long way to the left)
G03 X10. Y10. R-10. F100 (expect moves: ccw X10 Y10 @10,0)
M30
