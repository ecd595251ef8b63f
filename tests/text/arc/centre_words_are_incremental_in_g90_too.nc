O1 (ARC-1: from 10,10 the centre is 15,10)
G90 G00 X10. Y10.
G02 X20. Y10. I5. F100 (expect moves: cw X20 Y10 @15,10)
M30
