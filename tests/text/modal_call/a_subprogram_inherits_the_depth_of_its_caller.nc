O1 (CALL-17: motion in an M98 program triggers as in the main program)
G66 P2
M98 P3
G67
M30
O2
#100=#100+1
M99
O3
G90 G00 X1.
X2.
M99
(finally #100=2)
