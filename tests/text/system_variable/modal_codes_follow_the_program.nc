O1 (section 3.2: each group has its own number)
G18 G91 G95 G20 G99 G59 G61
#100=#4002 (expect #100=18)
#101=#4003 (expect #101=91)
#102=#4005 (expect #102=95)
#103=#4006 (expect #103=20)
#104=#4010 (expect #104=99)
#105=#4014 (expect #105=59)
#106=#4015 (expect #106=61)
M30
