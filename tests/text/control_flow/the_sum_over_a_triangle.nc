O10 (section 5: 1 + 2+4 + 3+6+9 is 25)
#100=0
#1=1
WHILE[#1LE3]DO1
#2=1
WHILE[#2LE#1]DO2
#100=#100+#1*#2
#2=#2+1
END2
#1=#1+1
END1
M30
(finally #100=25, #1=4)
