O1 (section 4.2: -90 to 90)
#100=ATAN[1] (expect #100=45)
#101=ATAN[-1] (expect #101=-45)
M30
