O1 (CALL-1: no repeat is no call)
M98 P2 L0
#101=1
M30
O2
#100=1
M99
(finally #100=null, #101=1)
