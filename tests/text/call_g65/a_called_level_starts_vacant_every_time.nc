O1 (CALL-12: nothing is left of the first call)
G65 P2
G65 P2
M30
O2
#100=#5 (expect #100=null)
#5=1
M99
