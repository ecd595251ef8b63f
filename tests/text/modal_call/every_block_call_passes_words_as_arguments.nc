O1 (CALL-21: G becomes #10, the block is not executed)
G66.1 P9
G01 X5. F100 (expect moves: none)
G67
M30
O9
IF[#24EQ#0]GOTO 5
#100=#10 (expect #100=1)
#101=#24 (expect #101=5)
#102=#9 (expect #102=100)
N5 M99
