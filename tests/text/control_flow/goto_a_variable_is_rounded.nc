O1 (CTL-1: 9.6 goes to N10)
#1=9.6
GOTO#1
#100=1
N10 #101=1 (expect #100=null, #101=1)
M30
