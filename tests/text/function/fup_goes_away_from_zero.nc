O1 (section 4.2)
#100=FUP[1.2] (expect #100=2)
#101=FUP[-1.2] (expect #101=-2)
#102=FUP[2] (expect #102=2)
M30
