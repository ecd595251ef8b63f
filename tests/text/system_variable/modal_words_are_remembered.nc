O1 (section 3.2: D, H, M, S and T)
D6 H5 S800 T12 M60
#100=#4107 (expect #100=6)
#101=#4111 (expect #101=5)
#102=#4113 (expect #102=60)
#103=#4119 (expect #103=800)
#104=#4120 (expect #104=12)
M30
