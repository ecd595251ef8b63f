O1 (section 4.2: 0 to 360)
#100=ATAN[1]/[-1] (expect #100=135)
#101=ATAN[-1]/[-1] (expect #101=225)
#102=ATAN[-1]/[1] (expect #102=315)
#103=ATAN[2]/[0] (expect #103=90)
M30
