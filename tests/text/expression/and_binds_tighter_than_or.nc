O1 (EXP-2: 7 OR 8 AND 12 is 7 OR 8)
#100=7 OR 8 AND 12 (expect #100=15)
#101=12 XOR 10 (expect #101=6)
#102=12 AND 10 (expect #102=8)
M30
