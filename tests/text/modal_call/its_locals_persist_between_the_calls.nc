O1 (CALL-15: set by G66 once, then kept)
G66 P2 A1.
G90 G00 X1.
X2.
X3.
G67
X4.
M30
O2
#500=#1
#1=#1+1
M99
(finally #500=3)
