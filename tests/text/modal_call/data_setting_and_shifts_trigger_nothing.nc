O1 (CALL-14: G10, G52 and G92 name axes but do not move)
G66 P2
G10 L2 P2 X1.
G52 X0
G92 X0
G67
M30
O2
#100=#100+1
M99
(finally #100=null)
