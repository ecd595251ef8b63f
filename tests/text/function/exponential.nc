O1 (section 4.2: e to the first power)
#100=EXP[1] (expect #100=2.71828183)
#101=EXP[0] (expect #101=1)
M30
