O1 (section 6.2, specification I: #7 #8 #9 #11 #13)
G65 P2 D1. E2. F3. H4. M5.
M30
O2
#100=#7 (expect #100=1)
#101=#8 (expect #101=2)
#102=#9 (expect #102=3)
#103=#11 (expect #103=4)
#104=#13 (expect #104=5)
M99
