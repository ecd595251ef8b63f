O1 (NUM-3: the second axis is an angle)
G90 G16
G00 X10. Y90000 (expect moves: rapid X0 Y10)
G15
M30
