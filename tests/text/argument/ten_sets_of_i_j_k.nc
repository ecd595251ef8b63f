O1 (ARG-1: the tenth K is #33)
G65 P2 K1. K2. K3. K4. K5. K6. K7. K8. K9. K10.
M30
O2
#100=#6 (expect #100=1)
#101=#30 (expect #101=9)
#102=#33 (expect #102=10)
M99
