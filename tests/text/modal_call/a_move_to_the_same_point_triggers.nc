O1 (CALL-14: an axis word counts even without distance)
G66 P2
G90 G00 X0 (expect moves: none)
G67
M30
O2
#100=#100+1
M99
(finally #100=1)
