O1 (section 7.4: no overrun is longer than 1000)
G10 L50
N5440 P1 R1001. (expect alarm PS0231 at R1001.)
G11
M30
