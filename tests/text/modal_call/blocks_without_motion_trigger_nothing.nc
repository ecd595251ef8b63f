O1 (CALL-14: macro statements and dwells)
G66 P2
#101=1
G04 P10
G90 G00 X5.
G67
M30
O2
#100=#100+1
M99
(finally #100=1)
