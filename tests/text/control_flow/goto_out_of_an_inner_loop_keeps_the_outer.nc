O1 (CTL-16: N7 lies in DO1, not in DO2)
#1=1
WHILE[#1LE3]DO1
DO2
#100=#100+1
GOTO 7
END2
N7 #1=#1+1
END1
M30
(finally #100=3, #1=4)
