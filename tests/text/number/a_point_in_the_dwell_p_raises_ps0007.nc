O1 (NUM-8: P is an integer)
G04 P1. (expect alarm PS0007 at P1.)
M30
