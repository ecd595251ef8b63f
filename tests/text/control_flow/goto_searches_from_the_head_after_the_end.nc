O1 (CTL-2: N20 stands before the second GOTO)
GOTO 10
#100=1
N20 #101=1
M30
N10 #102=1
GOTO 20
(finally #100=null, #101=1, #102=1)
