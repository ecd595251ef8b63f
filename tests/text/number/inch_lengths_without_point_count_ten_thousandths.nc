O1 (NUM-2: X10000 is one inch)
G20
G90 G00 X10000 (expect moves: rapid X25.4)
Y1. (expect moves: rapid Y25.4)
M30
