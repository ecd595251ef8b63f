O1 (LEX-29: G01 is G1, M03 is M3, X0010. is X10.)
G1 X0010. F0100 (expect moves: line X10 F100)
G000 X5. (expect moves: rapid X5)
S500 M003
M30
(finally records: spindle cw 500)
