O1 (WCS-2: P1)
#7001=3.
G54.1
G90 G00 X0 (expect moves: rapid X3)
M30
