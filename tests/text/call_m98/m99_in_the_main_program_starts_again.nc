O1 (M99-3: endless, here left by a GOTO)
#500=#500+1
IF[#500EQ3]GOTO 9
M99
N9 M30
(finally #500=3)
