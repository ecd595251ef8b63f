O1 (ARC-2: the end may be written)
G90 G00 X10.
G03 X10. Y0 J5. F100 (expect moves: ccw X10 Y0 @10,5)
M30
