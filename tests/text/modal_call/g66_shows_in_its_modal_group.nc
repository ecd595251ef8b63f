O1 (section 3.2: #4012 is 66 or 67)
G66 P2
#100=#4012 (expect #100=66)
G67
#101=#4012 (expect #101=67)
M30
O2
M99
