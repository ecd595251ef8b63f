O1 (CALL-1: P30002 is three times O0002)
M98 P30002
M30
O2
#100=#100+1
M99
(finally #100=3)
