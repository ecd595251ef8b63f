O1 (ARG-2: D5. comes after the second I)
G65 A1.0 B2.0 I-3.0 I4.0 D5.0 P2
M30
O2
#100=#1 (expect #100=1)
#101=#2 (expect #101=2)
#102=#4 (expect #102=-3)
#103=#7 (expect #103=5)
M99
