O1 (G51.1: half a turn)
G51.1 X0 Y0
G90 G02 X10. Y0 I5. F100 (expect moves: cw X-10 Y0 @-5,0)
G50.1 X0 Y0
M30
