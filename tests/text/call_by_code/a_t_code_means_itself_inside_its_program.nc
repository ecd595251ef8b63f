(run with: --param TCS=1)
O1 (CODE-1: T in O9000 selects the tool)
T12
M30
O9000
#100=#100+1
T#149 M06
M99
(finally #100=1)
(finally records: tool 12)
