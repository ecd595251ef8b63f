O1 (LEX-7: N5 N6 is found as N5)
GOTO 5
#100=1
N5 N6
#101=1
M30
(finally #100=null, #101=1)
