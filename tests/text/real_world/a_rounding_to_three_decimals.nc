O1 (ROUND of a thousand times, divided again)
#1=12.34567
#100=ROUND[1000*#1]/1000 (expect #100=12.346)
M30
