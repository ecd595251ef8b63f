O1 (CALL-16: two triggers with L3)
G66 P2 L3
G90 G00 X1.
X2.
G67
M30
O2
#100=#100+1
M99
(finally #100=6)
