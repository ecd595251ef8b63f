O1 (ARC-5: the other side of the chord)
G03 X10. Y10. R10. F100 (expect moves: ccw X10 Y10 @0,10)
M30
