O1 (section 12.1 as printed: no F for the G01 of N1001)
N011 G66 P1000 X5000
N012 Z10000
N018 M30
O1000
N1001 G01 X#24 (expect alarm PS0011)
N1002 M99
(finally moves: rapid Z10)
