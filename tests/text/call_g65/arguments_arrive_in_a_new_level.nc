O1 (CALL-5: the locals of the caller reappear unchanged)
#1=9
G65 P2 A1. B2.
#103=#1 (expect #103=9)
M30
O2
#100=#1 (expect #100=1)
#101=#2 (expect #101=2)
#102=#3 (expect #102=null)
#1=77
M99
