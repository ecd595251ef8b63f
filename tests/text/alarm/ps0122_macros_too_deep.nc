O1 (PS0122: a macro that calls itself)
#100=0
G65 P2
M30
O2
#100=#100+1
G65 P2 (expect alarm PS0122)
M99
(finally #100=4)
