O1 (ARC-3, ARC-5: three quarters)
G02 X10. Y10. R-10. F100 (expect moves: cw X10 Y10 @0,10)
M30
