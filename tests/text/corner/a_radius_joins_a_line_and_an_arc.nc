O1 (line along X, then an arc about X10 Y0 of radius 5: the centre lies 1 from the line and 6 from X10)
G90 G01 X5. F100 ,R1.
G02 X15. Y0 R5. (expect moves: cw X15 Y0 @10,0)
M30
(finally moves: line X4.0839 Y0; ccw X5.0699 Y0.8333 @4.0839,1 XY; cw X15 Y0 @10,0)
