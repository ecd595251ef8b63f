O1 (ARG-3: J1. I2. is #5 and #7)
G65 P2 J1. I2.
M30
O2
#100=#5 (expect #100=1)
#101=#7 (expect #101=2)
#102=#4 (expect #102=null)
M99
