O1 (section 8.3: #5221 is X of G54)
#5221=100.
G54 G90 G00 X1. (expect moves: rapid X101)
#100=#5021 (expect #100=101)
M30
