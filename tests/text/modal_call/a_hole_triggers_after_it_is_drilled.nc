O1 (CALL-14: once for the whole cycle)
G90 G00 Z10.
G66 P2
G99 G81 X1. Y0 Z-5. R2. F100
G67
G80
M30
O2
#100=#100+1
#101=#5003 (expect #101=2)
M99
(finally #100=1)
