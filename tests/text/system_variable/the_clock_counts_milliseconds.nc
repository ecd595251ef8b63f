O1 (section 3.1: a dwell of 250 ms passes on the clock)
#3001=0
G04 P250
#1=#3001
IF[ABS[#1-250]LT20]THEN #100=1 (expect #100=1)
M30
