O1 (CTL-18: the blocks between are executed)
GOTO 5
DO1
N5 #100=1
END1 (expect alarm PS1124)
M30
(finally #100=1)
