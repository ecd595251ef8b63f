O1 (NAT 0: negative arguments give the fourth quadrant)
#100=ASIN[0.5] (expect #100=30)
#101=ASIN[-0.5] (expect #101=330)
#102=ASIN[-1] (expect #102=270)
M30
