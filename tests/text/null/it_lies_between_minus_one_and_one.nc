O1 (NUL-4: as 0 it is ordered against other numbers)
IF[#1LT1]THEN #100=1 (expect #100=1)
IF[#1GT-1]THEN #101=1 (expect #101=1)
M30
