O1 (group 06: lengths and feeds)
G20
G90 G01 X1. F10. (expect moves: line X25.4 F254)
#100=#5001 (expect #100=1)
M30
(finally machine X25.4)
