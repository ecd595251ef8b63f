O1 (CALL-18: the one before is on again)
G66 P2
G66 P3
G67
G90 G00 X1.
G67
M30
O2
#100=#100+1
M99
O3
#101=#101+1
M99
(finally #100=1, #101=null)
