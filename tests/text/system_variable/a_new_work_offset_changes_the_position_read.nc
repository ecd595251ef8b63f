O1 (section 3.4: the point stays, its coordinate changes)
#5221=10.
#100=#5001 (expect #100=-10)
G90 G00 X0 (expect moves: rapid X10)
M30
