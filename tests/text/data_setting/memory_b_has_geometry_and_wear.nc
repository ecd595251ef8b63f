(run with: --param offset_memory=B)
O1 (section 7.4: L10 geometry, L11 wear)
G10 L10 P3 R7.
G10 L11 P3 R0.2
#100=#11003 (expect #100=7)
#101=#10003 (expect #101=0.2)
M30
