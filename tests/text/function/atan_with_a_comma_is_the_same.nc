O1 (section 4.2: ATAN[y,x])
#100=ATAN[1,-1] (expect #100=135)
#101=ATAN[-1,-1] (expect #101=225)
M30
