O1 (WCS-3: the second G52 replaces the first)
G52 X10.
G52 X4.
G90 G00 X0 (expect moves: rapid X4)
M30
