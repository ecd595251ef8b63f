O1 (CTL-1: GOTO#1)
#1=20
GOTO#1
#100=1
N20 #101=1 (expect #100=null, #101=1)
M30
