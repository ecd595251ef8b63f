O1 (,R: 2 mm before the corner, then a quarter circle)
G90 G01 X10. F100 ,R2. (expect moves: line X8 Y0; ccw X10 Y2 @8,2 XY)
Y10. (expect moves: line X10 Y10)
M30
