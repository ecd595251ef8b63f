O1 (OUT-5: 123.456 in format 20 is 23)
#30=123.456
#5=-91.2
DPRNT[T#30[20]Y#5[53]]
M30
(finally prints T23Y-91.200)
