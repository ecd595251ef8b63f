O1 (CTL-7: exactly one of two)
IF[[1EQ1]XOR[1EQ2]]THEN #100=1 (expect #100=1)
IF[[1EQ1]XOR[2EQ2]]THEN #101=1 (expect #101=null)
M30
