O1 (CALL-17: its own motion calls nothing)
G66 P2
G90 G00 X1.
G67
M30
O2
#100=#100+1
Z[#100]
M99
(finally #100=1)
(finally moves: rapid X1; rapid Z1)
