O1 (section 3.1: parts machined and required)
#3901=5
#3902=20
#100=#3901 (expect #100=5)
#101=#3902 (expect #101=20)
M30
