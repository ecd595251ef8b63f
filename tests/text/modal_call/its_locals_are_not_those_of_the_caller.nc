O1 (CALL-15: #1 of the main program stays)
#1=9
G66 P2 A1.
G90 G00 X1.
G67
#101=#1 (expect #101=9)
M30
O2
#1=#1+1
#100=#1 (expect #100=2)
M99
