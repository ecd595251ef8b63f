O1 (VAR-7: G#1 X1. moves in the mode that is on)
G01 F100
G#1 X1. (expect moves: line X1)
M30
