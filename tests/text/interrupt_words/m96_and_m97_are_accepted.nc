O1 (section 7.3: without a signal nothing is called)
M96 P2
G90 G00 X1. (expect moves: rapid X1)
M97
X2. (expect moves: rapid X2)
M30
O2
#100=1
M99
(finally #100=null)
