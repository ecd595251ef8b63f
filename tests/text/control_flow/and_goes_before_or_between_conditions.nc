O1 (CTL-8: true OR false is tried last)
IF[[1EQ1]OR[1EQ1]AND[1EQ2]]THEN #100=1 (expect #100=1)
M30
