O1 (CALL-11: G91 is still on after M99)
G65 P2
#100=#4003 (expect #100=91)
M30
O2
G91
M99
