O1 (section 4.2: multiples of 30, 45 and 90 degrees)
IF[SIN[30]EQ0.5]THEN #100=1 (expect #100=1)
IF[COS[60]EQ0.5]THEN #101=1 (expect #101=1)
IF[TAN[45]EQ1]THEN #102=1 (expect #102=1)
IF[COS[90]EQ0]THEN #103=1 (expect #103=1)
IF[SIN[180]EQ0]THEN #104=1 (expect #104=1)
IF[SIN[-390]EQ-0.5]THEN #105=1 (expect #105=1)
M30
