O1 (section 4.2: 12 becomes hexadecimal 12)
#100=BCD[12] (expect #100=18)
M30
