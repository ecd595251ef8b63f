O1 (G18: the corner lies in Z and X)
G90 G18 G01 Z10. F100 ,R2. (expect moves: line Z8 X0; ccw Z10 X2 @8,2 ZX)
X10. (expect moves: line X10 Z10)
M30
