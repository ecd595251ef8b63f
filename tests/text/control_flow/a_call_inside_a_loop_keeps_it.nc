O1 (CTL-19: the subprogram has a loop of the same number)
#1=0
WHILE[#1LT3]DO1
M98 P2
#1=#1+1
END1
M30
O2
#2=0
WHILE[#2LT2]DO1
#2=#2+1
#100=#100+1
END1
M99
(finally #100=6)
