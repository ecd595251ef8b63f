O1 (CTL-1: the blocks between are not executed)
GOTO 10
#100=1
N10 #101=1 (expect #100=null, #101=1)
M30
