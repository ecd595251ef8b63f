O1 (ATAN[a]/[SQRT[1-a*a]])
#1=0.5
#100=ATAN[#1]/[SQRT[1-#1*#1]] (expect #100=30)
M30
