O1 (NUL-5: [#1] is vacant, [#1+0] is 0)
IF[[#1]EQ#0]THEN #100=1 (expect #100=1)
IF[[#1+0]EQ#0]THEN #101=1 (expect #101=null)
#102=[#1] (expect #102=null)
M30
