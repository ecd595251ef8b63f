O1 (NUM-11: X5000 is 5 mm, Z10000 is 10 mm, Z-25000 is -25 mm)
G90 G00 X5000 (expect moves: rapid X5)
Z10000 (expect moves: rapid Z10)
Z-25000 (expect moves: rapid Z-25)
M30
