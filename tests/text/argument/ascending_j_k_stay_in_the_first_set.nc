O1 (ARG-3: J1. K2. is #5 and #6)
G65 P2 J1. K2.
M30
O2
#100=#5 (expect #100=1)
#101=#6 (expect #101=2)
M99
