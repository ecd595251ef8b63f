O1 (ARC-3, ARC-5: a quarter circle)
G02 X10. Y10. R10. F100 (expect moves: cw X10 Y10 @10,0)
M30
