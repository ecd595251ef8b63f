O1 (section 2: #100 is null at power on)
IF[#100EQ#0]THEN #101=1 (expect #101=1)
IF[#199EQ#0]THEN #102=1 (expect #102=1)
M30
