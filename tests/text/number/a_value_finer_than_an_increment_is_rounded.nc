O1 (NUM-14: 12.3456 becomes 12.346)
#1=12.3456
G90 G00 X#1 (expect moves: rapid X12.346)
#100=#5001 (expect #100=12.346)
M30
