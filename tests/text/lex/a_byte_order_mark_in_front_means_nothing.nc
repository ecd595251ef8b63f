O1 (LEX-1: some editors write one)
G00 X5. (expect moves: rapid X5)
G01 Y1. F100
M30
