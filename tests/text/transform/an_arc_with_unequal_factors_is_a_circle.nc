O1 (an arc stays a circle: R by the larger factor)
G90 G00 X0 Y0
G51 X0 Y0 I2000 J1000
G02 X10. Y0 R5. F100 (expect moves: cw X20 Y0 @10,0 XY) (expect assumed: unequal)
M30
