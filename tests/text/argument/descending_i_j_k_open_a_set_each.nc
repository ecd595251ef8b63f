O1 (ARG-1: K1. J2. I3. is #6, #8 and #10)
G65 P2 K1. J2. I3.
M30
O2
#100=#6 (expect #100=1)
#101=#8 (expect #101=2)
#102=#10 (expect #102=3)
#103=#4 (expect #103=null)
M99
