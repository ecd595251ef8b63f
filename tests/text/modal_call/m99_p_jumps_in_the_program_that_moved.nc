O1 (CALL-20: N50 of the main program)
G66 P2
G90 G00 X1.
#100=1
N50 G67
M30
O2
M99 P50
(finally #100=null)
