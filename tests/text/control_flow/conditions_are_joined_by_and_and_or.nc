O1 (CTL-7: each comparison in its own brackets)
#1=1
#2=2
IF[[#1EQ1]AND[#2EQ2]]THEN #100=1 (expect #100=1)
IF[[#1EQ5]OR[#2EQ2]]THEN #101=1 (expect #101=1)
IF[[#1EQ1]AND[#2EQ5]]THEN #102=1 (expect #102=null)
M30
