O1 (LEX-30: X1. G00 Y2. is G00 X1. Y2.)
G01 F100
X1. G00 Y2. (expect moves: rapid X1 Y2)
M30
