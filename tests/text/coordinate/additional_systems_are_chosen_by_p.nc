O1 (WCS-2: G54.1 P3)
G54.1 P3
#7041=7.
G90 G00 X0 (expect moves: rapid X7)
#101=#4014 (expect #101=54.1)
#102=#4130 (expect #102=3)
M30
