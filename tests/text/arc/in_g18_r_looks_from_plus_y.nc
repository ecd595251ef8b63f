O1 (ARC-5, ARC-11: G03 turns from Z to X)
G90 G00 Z10.
G18 G03 X10. Z0 R10. F100 (expect moves: ccw X10 Z0 @0,0 ZX)
M30
