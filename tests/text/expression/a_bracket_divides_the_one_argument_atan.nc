O1 (EXP-9: [ATAN[1]]/2 is 22.5)
#100=[ATAN[1]]/2 (expect #100=22.5)
M30
