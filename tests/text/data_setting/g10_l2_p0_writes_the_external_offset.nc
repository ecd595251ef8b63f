O1 (section 7.4: P0 is EXT)
G90 G10 L2 P0 X4.
#100=#5201 (expect #100=4)
G00 X1. (expect moves: rapid X5)
M30
