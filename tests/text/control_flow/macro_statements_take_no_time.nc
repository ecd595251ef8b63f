O1 (CTL-22: the clock stands still during a loop)
#3001=0
#1=0
WHILE[#1LT500]DO1
#1=#1+1
END1
#100=#3001 (expect #100=0)
M30
