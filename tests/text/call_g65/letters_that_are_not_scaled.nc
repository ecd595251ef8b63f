O1 (CALL-7: D H M S T and E F)
G65 P2 D1 H2 M3 S4 T5 E6 F7
M30
O2
#100=#7 (expect #100=1)
#101=#11 (expect #101=2)
#102=#13 (expect #102=3)
#103=#19 (expect #103=4)
#104=#20 (expect #104=5)
#105=#8 (expect #105=6)
#106=#9 (expect #106=7)
M99
