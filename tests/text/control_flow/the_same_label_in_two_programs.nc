O1 (CTL-2: each program has its own N10)
M98 P2
GOTO 10
#100=1
N10 M30
O2
GOTO 10
#101=1
N10 #102=1
M99
(finally #100=null, #101=null, #102=1)
