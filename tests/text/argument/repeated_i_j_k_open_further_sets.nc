O1 (ARG-1: I1. J2. I3. K4.)
G65 P2 I1. J2. I3. K4.
M30
O2
#100=#4 (expect #100=1)
#101=#5 (expect #101=2)
#102=#6 (expect #102=null)
#103=#7 (expect #103=3)
#104=#8 (expect #104=null)
#105=#9 (expect #105=4)
M99
