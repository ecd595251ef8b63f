O1 (G51: the current position is the centre)
G90 G00 X10.
G51 P2000
X15. (expect moves: rapid X20)
G50
M30
