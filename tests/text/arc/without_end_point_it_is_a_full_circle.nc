O1 (ARC-2: G02 I5.)
G02 I5. F100 (expect moves: cw X0 Y0 @5,0)
M30
