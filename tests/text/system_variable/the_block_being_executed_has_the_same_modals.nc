O1 (section 3.2: #42xx equals #40xx without look-ahead)
G91
#100=#4203 (expect #100=91)
F150.
#101=#4309 (expect #101=150)
M30
