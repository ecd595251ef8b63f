O1 (section 4.2)
#100=SIN[30] (expect #100=0.5)
#101=COS[60] (expect #101=0.5)
#102=TAN[45] (expect #102=1)
#103=SIN[10] (expect #103=0.17364818)
M30
