O1 (section 8.5: X is doubled, then turned into Y)
G51 X0 Y0 I2000 J1000
G68 X0 Y0 R90.
G90 G00 X10. Y0 (expect moves: rapid X0 Y20)
G69
G50
M30
