O1 (CTL-5)
#1=7
#2=7
IF[#1EQ#2]THEN #100=0 (expect #100=0)
IF[#1NE#2]THEN #101=0 (expect #101=null)
M30
