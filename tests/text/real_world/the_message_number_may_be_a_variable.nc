O1 (#3006=#120)
#120=3
#3006=#120(MEASURE TOOL 3)
#100=1 (expect #100=1)
M30
(finally records: message MEASURE TOOL 3)
