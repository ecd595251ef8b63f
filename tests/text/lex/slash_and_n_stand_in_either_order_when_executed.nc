O1 (LEX-6: with the switch off both forms are ordinary blocks)
N10/2 G00 X1. (expect moves: rapid X1)
/2 N20 G00 X2. (expect moves: rapid X2)
M30
