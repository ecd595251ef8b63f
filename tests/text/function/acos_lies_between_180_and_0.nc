O1 (section 4.2)
#100=ACOS[-0.5] (expect #100=120)
#101=ACOS[1] (expect #101=0)
#102=ACOS[-1] (expect #102=180)
M30
