O1 (CTL-3: the branch is never taken)
#1=1
IF[#1EQ2]GOTO 99
#100=1 (expect #100=1)
M30
