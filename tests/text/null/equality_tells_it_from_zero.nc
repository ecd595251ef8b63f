O1 (NUL-3: EQ and NE)
IF[#1EQ#0]THEN #100=1 (expect #100=1)
IF[#1EQ0]THEN #101=1 (expect #101=null)
IF[#1NE0]THEN #102=1 (expect #102=1)
IF[#1NE#0]THEN #103=1 (expect #103=null)
M30
