O1 (CALL-7: Q R U V W Z count thousandths)
G65 P2 Q1000 R2000 U3000 V4000 W5000 Z6000
M30
O2
#100=#17 (expect #100=1)
#101=#18 (expect #101=2)
#102=#21 (expect #102=3)
#103=#22 (expect #103=4)
#104=#23 (expect #104=5)
#105=#26 (expect #105=6)
M99
