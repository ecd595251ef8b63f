O1 (CTL-1: a jump table of two)
#1=2
GOTO[#1*10]
N10 #100=1
N20 #101=1 (expect #100=null, #101=1)
M30
