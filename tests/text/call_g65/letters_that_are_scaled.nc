O1 (CALL-7: A B C I J K count thousandths)
G65 P2 A1000 B2000 C3000 I4000 J5000 K6000
M30
O2
#100=#1 (expect #100=1)
#101=#2 (expect #101=2)
#102=#3 (expect #102=3)
#103=#4 (expect #103=4)
#104=#5 (expect #104=5)
#105=#6 (expect #105=6)
M99
