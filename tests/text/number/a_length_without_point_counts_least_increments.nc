O1 (NUM-1, NUM-11: X1000 is 1 mm)
G90 G00 X1000 Y1. (expect moves: rapid X1 Y1) (expect assumed: least increments)
M30
