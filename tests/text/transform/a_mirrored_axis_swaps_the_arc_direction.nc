O1 (G51.1: G02 becomes counterclockwise)
G51.1 X0
G90 G02 X10. Y0 I5. F100 (expect moves: ccw X-10 Y0 @-5,0)
G50.1 X0
M30
