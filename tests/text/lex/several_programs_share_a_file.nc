O1 (LEX-4: a new O block starts the next program of the file)
M98 P3
#101=#100 (expect #101=3)
M30
O2
#100=2
M99
O3
#100=3
M99
