O1 (G51: centre and end)
G51 X0 Y0 P2000
G90 G02 X10. Y0 I5. F100 (expect moves: cw X20 Y0 @10,0)
G50
M30
