O1 (M98 P Q: not from the head)
M98 P2 Q20
M30
O2
#100=1
N20 #101=1 (expect #100=null, #101=1)
M99
