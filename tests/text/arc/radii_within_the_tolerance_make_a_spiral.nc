O1 (ARC-7: 5.000 and 5.008)
G02 X10.008 Y0 I5. F100 (expect moves: cw X10.008 Y0 @5,0)
M30
