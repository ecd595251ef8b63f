O1 (CTL-19: the loop of the caller goes on)
#1=0
WHILE[#1LT3]DO1
M98 P2
#1=#1+1
END1
M30
O2
DO1
#100=#100+1
M99
END1
(finally #100=3, #1=3)
