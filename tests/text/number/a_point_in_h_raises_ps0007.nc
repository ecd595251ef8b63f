O1 (NUM-9: H is an integer)
G43 H1. Z0 (expect alarm PS0007 at H1.)
M30
