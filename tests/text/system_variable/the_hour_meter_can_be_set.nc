O1 (section 3.1: #3002 counts hours)
#3002=5
IF[ABS[#3002-5]LT0.1]THEN #100=1 (expect #100=1)
M30
