O1 (section 7.4: a probing macro sets the offset)
#1=3
#2=12.3456
G90 G10 L2 P#1 X#2
#100=#5261 (expect #100=12.346)
M30
