O1 (SQ, AS and RO)
#100=SQ[16] (expect #100=4)
#101=AS[0.5] (expect #101=30)
#102=RO[2.5] (expect #102=3)
M30
