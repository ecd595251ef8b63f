O1 (G-2: no F since power on)
G01 X1. (expect alarm PS0011)
M30
(finally moves: none)
