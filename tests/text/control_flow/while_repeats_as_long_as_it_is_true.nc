O1 (CTL-10: the sum of 1 to 5)
#1=1
#100=0
WHILE[#1LE5]DO1
#100=#100+#1
#1=#1+1
END1
M30
(finally #100=15, #1=6)
