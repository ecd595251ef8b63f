O1 (REF-1: X and Y, not Z)
G90 G00 X5. Y6. Z7.
G91 G28 X0 Y0 (expect moves: rapid X0 Y0 Z7)
M30
