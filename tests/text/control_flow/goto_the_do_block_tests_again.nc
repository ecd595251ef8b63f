O1 (CTL-20: no second loop is stacked)
#1=0
N5 WHILE[#1LT5]DO1
#1=#1+1
#100=#100+1
IF[#1LT4]GOTO 5
END1
M30
(finally #1=5, #100=5)
