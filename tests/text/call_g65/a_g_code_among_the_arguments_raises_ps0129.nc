O1 (CALL-4: G is no argument letter)
G65 P2 G1 X1. (expect alarm PS0129 at G1)
M30
O2
M99
