O1 (CALL-21: they are executed, not passed)
G66.1 P9
#101=5
G67
#102=#101 (expect #102=5)
M30
O9
#100=#100+1
M99
