O1 (EXP-10: 0.1+0.2 is not 0.3 in binary)
#1=0.1+0.2
IF[#1EQ0.3]THEN #100=1 (expect #100=null)
IF[#1NE0.3]THEN #101=1 (expect #101=1)
M30
