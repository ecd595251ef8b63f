O1 (section 4.2)
#100=ABS[-3.2] (expect #100=3.2)
#101=ABS[3.2] (expect #101=3.2)
M30
