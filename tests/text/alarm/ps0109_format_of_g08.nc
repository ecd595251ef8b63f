O1 (PS0109: G08 takes P0 and P1)
G08 P7 (expect alarm PS0109)
M30
