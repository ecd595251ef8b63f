O1 (group 05: G94 is mm a minute)
G93 G01 X1. F2.
G94 X2. F120 (expect moves: line X2 F120)
M30
