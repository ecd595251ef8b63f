O1 (section 8.5: G16 comes first)
G68 X0 Y0 R60.
G90 G16 G00 X10. Y30. (expect moves: rapid X0 Y10)
G15
G69
M30
