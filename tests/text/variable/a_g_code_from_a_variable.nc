O1 (VAR-6: G#3 with 91)
#3=91
G00 X1.
G#3
X1. (expect moves: rapid X2)
M30
