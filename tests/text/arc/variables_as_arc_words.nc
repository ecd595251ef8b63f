O1 (VAR-6: I#1, X[..])
#1=5.
G90 G03 X[2*#1] Y0 I#1 F100 (expect moves: ccw X10 Y0 @5,0)
M30
