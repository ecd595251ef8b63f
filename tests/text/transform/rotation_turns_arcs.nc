O1 (G68: end and centre turn, the direction stays)
G68 X0 Y0 R90.
G90 G02 X10. Y0 I5. F100 (expect moves: cw X0 Y10 @0,5)
G69
M30
