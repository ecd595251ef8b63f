O1 (section 12.1: the mixing example, #7 is 5)
G65 A1.0 B2.0 I-3.0 I4.0 D5.0 P1000
M30
O1000
#101=#1 (expect #101=1)
#102=#2 (expect #102=2)
#104=#4 (expect #104=-3)
#107=#7 (expect #107=5)
M99
