(run with: --param offset_memory=B)
O1 (section 3.5: #2003 is wear, #2203 geometry)
#2003=0.5
#2203=20.
#100=#10003 (expect #100=0.5)
#101=#11003 (expect #101=20)
G43 H3 Z0
#102=#5083 (expect #102=20.5)
M30
