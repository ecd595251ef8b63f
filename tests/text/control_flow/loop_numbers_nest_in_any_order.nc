O1 (CTL-12: 3 outside, 1 inside)
#1=1
WHILE[#1LE2]DO3
#2=1
WHILE[#2LE3]DO1
#100=#100+1
#2=#2+1
END1
#1=#1+1
END3
M30
(finally #100=6)
