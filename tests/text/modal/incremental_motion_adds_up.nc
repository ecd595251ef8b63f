O1 (LEX-30: G91 in front of G00)
G91 X1. G00 Y1. (expect moves: rapid X1 Y1)
X1. Y1. (expect moves: rapid X2 Y2)
M30
