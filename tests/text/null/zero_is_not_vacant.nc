O1 (NUL-3: the same tests with #1=0)
#1=0
IF[#1EQ#0]THEN #100=1 (expect #100=null)
IF[#1NE#0]THEN #101=1 (expect #101=1)
IF[#1EQ0]THEN #102=1 (expect #102=1)
M30
