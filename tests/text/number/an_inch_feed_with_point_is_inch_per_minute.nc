O1 (NUM-4: 10 inch a minute are 254 mm a minute)
G20
G90 G01 X1. F10. (expect moves: line X25.4 F254)
M30
