O7 (section 3.2: #4115 in the main program and in a macro)
#100=#4115 (expect #100=7)
G65 P9123
#102=#4115 (expect #102=7)
M30
O9123
#101=#4115 (expect #101=9123)
M99
