O1 (ARG-5: A1. A2.)
G65 P2 A1. A2.
M30
O2
#100=#1 (expect #100=2)
M99
