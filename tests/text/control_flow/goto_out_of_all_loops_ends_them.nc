O1 (CTL-16: both loops can be entered again)
N1 #100=#100+1
DO1
DO2
IF[#100LT5]GOTO 1
GOTO 9
END2
END1
N9 M30
(finally #100=5)
