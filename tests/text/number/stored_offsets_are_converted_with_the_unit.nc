O1 (NUM-18: #5221 is the same length in inch)
G21
#5221=25.4
G20
#100=#5221 (expect #100=1)
G21
#101=#5221 (expect #101=25.4)
M30
