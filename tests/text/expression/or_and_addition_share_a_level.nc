O1 (EXP-3: from left to right)
#100=1+2 OR 4 (expect #100=7)
#101=4 OR 1+2 (expect #101=7)
#102=1 OR 1+1 (expect #102=2)
M30
