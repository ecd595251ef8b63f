O1 (CALL-2: no new level)
#1=5
M98 P2
#101=#1 (expect #101=6)
M30
O2
#1=#1+1
#100=#1 (expect #100=6)
M99
