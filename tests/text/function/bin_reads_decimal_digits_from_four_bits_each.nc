O1 (section 4.2: 18 is hexadecimal 12)
#100=BIN[18] (expect #100=12)
M30
