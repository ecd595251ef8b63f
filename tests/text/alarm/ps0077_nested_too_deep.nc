O1 (PS0077: a subprogram that calls itself)
M98 P2
M30
O2
M98 P2 (expect alarm PS0077)
M99
