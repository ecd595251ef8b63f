O1 (CTL-17: the jump skips one statement)
#1=0
WHILE[#1LT4]DO1
#1=#1+1
IF[#1EQ2]GOTO 3
#100=#100+1
N3 END1
M30
(finally #100=3, #1=4)
