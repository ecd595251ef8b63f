O1 (CTL-10: no pass at all)
#1=9
WHILE[#1LT5]DO1
#100=1
END1
#101=2
M30
(finally #100=null, #101=2)
