O1 (NUM-18: #100 stays a plain number)
#100=25.4
G20
#101=#100 (expect #101=25.4)
G90 G00 X[#100/25.4] (expect moves: rapid X25.4)
M30
