O1 (ARG-2: the second I comes after D5.)
G65 P2 A1. B2. D5.0 I-3.0 I4.0
M30
O2
#100=#4 (expect #100=-3)
#101=#7 (expect #101=4)
M99
