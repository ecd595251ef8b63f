O1 (no brackets around)
#2= -21.3 + 6. (expect #2=-15.3)
#8= 12. -0.2 (expect #8=11.8)
#9=45
#1=2
#10= - TAN[ #9 ] * #1 (expect #10=-2)
M30
