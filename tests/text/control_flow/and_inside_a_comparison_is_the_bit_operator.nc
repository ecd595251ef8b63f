O1 (CTL-9: AND binds tighter than EQ)
#15=2
IF[#15 AND 1 EQ 0]THEN #100=1 (expect #100=1)
IF[[#15 AND 1]EQ 0]THEN #101=1 (expect #101=1)
IF[#15 AND 2 EQ 0]THEN #102=1 (expect #102=null)
M30
