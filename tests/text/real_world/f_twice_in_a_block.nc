O1 (the last one counts)
G1 F50 X1. F80 (expect moves: line X1 F80)
M30
