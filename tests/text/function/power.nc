O1 (section 4.2: POW[2,10] is 1024)
#100=POW[2,10] (expect #100=1024)
#101=POW[2,-1] (expect #101=0.5)
M30
