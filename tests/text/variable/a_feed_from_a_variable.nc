O1 (VAR-6: F#33 with 1.5)
#33=1.5
G01 X1. F#33 (expect moves: line X1 F1.5)
M30
