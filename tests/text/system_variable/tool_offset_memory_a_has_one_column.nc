(run with: --param offset_memory=A)
O1 (section 3.5: #2003 is #10003)
#2003=5.
#100=#10003 (expect #100=5)
G43 H3 Z0
#101=#5083 (expect #101=5)
M30
