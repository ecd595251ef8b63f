O1 (ARC-3: I is not looked at)
G02 X10. Y0 R5. I99. F100 (expect moves: cw X10 Y0 @5,0)
M30
