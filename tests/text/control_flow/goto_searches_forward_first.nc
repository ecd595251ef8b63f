O1 (CTL-2: of two equal labels the later one is nearer)
#100=0
N10 #100=#100+1
IF[#100GT1]GOTO 20
GOTO 10
#101=1
N10 #102=1
N20 M30
(finally #100=1, #101=null, #102=1)
