O1 (CALL-13: in the G66 block)
#1=3
G66 P2 A#1
#1=9
G90 G00 X1.
G67
M30
O2
#100=#1
M99
(finally #100=3)
