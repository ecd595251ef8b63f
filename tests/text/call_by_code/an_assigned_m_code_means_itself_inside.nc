(run with: --param 6071=6)
O1 (CODE-1: M06 in O9001 is the tool change)
T3
M06
M30
O9001
#100=#100+1
M06
M99
(finally #100=1)
(finally records: tool 3)
