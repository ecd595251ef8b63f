O1 (section 4.2: 32 bits with sign)
#100=-1 AND 15 (expect #100=15)
#101=-8 OR 1 (expect #101=-7)
#102=-1 XOR 0 (expect #102=-1)
M30
