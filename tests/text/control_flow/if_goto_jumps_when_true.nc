O1 (CTL-4: counting with a backward jump)
#100=0
N1 #100=#100+1
IF[#100LT3]GOTO 1
M30
(finally #100=3)
