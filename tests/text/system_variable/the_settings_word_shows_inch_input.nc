O1 (section 3.1: bit 2 of #3005)
#100=#3005AND4 (expect #100=0)
G20
#101=#3005AND4 (expect #101=4)
M30
