O1 (NUM-12: X without and Y with point in one block)
G90 G00 X1000 Y1. Z-500 (expect moves: rapid X1 Y1 Z-0.5)
M30
