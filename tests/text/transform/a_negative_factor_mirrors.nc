O1 (G51: I-1000, and arcs turn the other way)
G51 X0 Y0 I-1000 J1000
G90 G00 X3. Y4. (expect moves: rapid X-3 Y4)
G02 X5. Y4. I1. F100 (expect moves: ccw X-5 Y4 @-4,4)
G50
M30
