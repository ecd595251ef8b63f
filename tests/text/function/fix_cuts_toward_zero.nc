O1 (section 4.2)
#100=FIX[1.9] (expect #100=1)
#101=FIX[-1.2] (expect #101=-1)
M30
