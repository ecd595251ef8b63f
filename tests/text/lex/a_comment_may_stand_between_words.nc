O1 (LEX-13: G00 FAST X1. is G00 X1.)
G01 F100
G00(FAST)X1.(AND FAR) Y2. (expect moves: rapid X1 Y2)
M30
