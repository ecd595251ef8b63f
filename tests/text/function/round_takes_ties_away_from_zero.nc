O1 (section 4.2)
#100=ROUND[2.5] (expect #100=3)
#101=ROUND[-2.5] (expect #101=-3)
#102=ROUND[1.4999] (expect #102=1)
M30
