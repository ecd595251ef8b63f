O1 (LEX-31: X1. X5. goes to 5)
G90 G00 X1. X5. (expect moves: rapid X5)
M30
