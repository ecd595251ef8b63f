O1 (a CAM system that prints doubles)
G90 G0 X1.1234567890123456 Y-0.0004123456789012 (expect moves: rapid X1.123 Y0)
M30
