O1 (section 4.2: no direction)
#100=ATAN[0]/[0] (expect #100=0)
M30
