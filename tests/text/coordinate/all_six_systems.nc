O1 (WCS-1: G54 to G59)
#5221=1.
#5241=2.
#5261=3.
#5281=4.
#5301=5.
#5321=6.
G90 G00
G55 X0 (expect moves: rapid X2)
G56 X0 (expect moves: rapid X3)
G57 X0 (expect moves: rapid X4)
G58 X0 (expect moves: rapid X5)
G59 X0 (expect moves: rapid X6)
G54 X0 (expect moves: rapid X1)
M30
