O1 (NUL-4: GE, LE, GT and LT)
IF[#1GE0]THEN #100=1 (expect #100=1)
IF[#1LE0]THEN #101=1 (expect #101=1)
IF[#1GT0]THEN #102=1 (expect #102=null)
IF[#1LT0]THEN #103=1 (expect #103=null)
IF[#1GE#0]THEN #104=1 (expect #104=1)
M30
