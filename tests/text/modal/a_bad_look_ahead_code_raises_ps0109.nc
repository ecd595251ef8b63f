O1 (section 8.1: G08 takes P0 and P1)
G08 P2 (expect alarm PS0109)
M30
