O1 (section 4.1: EQ NE GT GE LT LE)
IF[2EQ2]THEN #100=1 (expect #100=1)
IF[2NE3]THEN #101=1 (expect #101=1)
IF[3GT2]THEN #102=1 (expect #102=1)
IF[2GE2]THEN #103=1 (expect #103=1)
IF[2LT2]THEN #104=1 (expect #104=null)
IF[2LE2]THEN #105=1 (expect #105=1)
M30
