O1 (ARC-11: from X10 to Z10)
G90 G00 X10.
G18 G02 Z10. X0 I-10. K0 F100 (expect moves: cw X0 Z10 @0,0 ZX)
M30
