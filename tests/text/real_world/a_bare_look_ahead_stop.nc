O1 (G31 and G53 without axes move nothing)
G90 G0 X5.
G31 (expect moves: none)
G53 (expect moves: none)
#100=#5001 (expect #100=5)
M30
