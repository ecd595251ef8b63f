O1 (NUM-4: F1000 is 10 inch a minute)
G20
G90 G01 X1. F1000 (expect moves: line X25.4 F254)
M30
