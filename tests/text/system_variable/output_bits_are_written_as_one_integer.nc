O1 (section 3.1: #1132=5 is bits 0 and 2)
#1132=5
#100=#1100 (expect #100=1)
#101=#1101 (expect #101=0)
#102=#1102 (expect #102=1)
M30
