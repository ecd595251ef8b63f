O1 (NUL-9: anything else than 0 switches the bit on)
#1100=#0
#100=#1100 (expect #100=0)
#1101=9
#101=#1101 (expect #101=1)
M30
