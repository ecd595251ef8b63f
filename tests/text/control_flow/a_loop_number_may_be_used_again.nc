O1 (CTL-12: one DO1 after the other)
#1=1
WHILE[#1LE2]DO1
#1=#1+1
END1
#1=1
WHILE[#1LE3]DO1
#100=#100+1
#1=#1+1
END1
M30
(finally #100=3)
