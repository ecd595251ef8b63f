O1 (LEX-32: Q says nothing to G01)
G01 X1. Q5. F100 (expect moves: line X1 F100)
M30
