O1 (WCS-2: #19981 is X of P300)
#19981=4.
G54.1 P300
G90 G00 X0 (expect moves: rapid X4)
G54.1 P301 (expect alarm PS0030 at P301)
M30
