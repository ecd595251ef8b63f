O1 (section 3.2: motion, distance mode and feed)
G91 G01 X1. F150.
#100=#4001 (expect #100=1)
#101=#4003 (expect #101=91)
#102=#4109 (expect #102=150)
M30
