O1 (LEX-24: X1E3 is the two words X1 and E3)
G65 P2 X1E3
M30
O2
#100=#24 (expect #100=0.001)
#101=#8 (expect #101=3)
M99
