O1 (section 8: M99 is among the last)
M98 P2
#100=#5001 (expect #100=5)
M30
O2
M99 G90 G00 X5. (expect moves: rapid X5)
