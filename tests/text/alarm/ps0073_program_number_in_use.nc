O1 (PS0073: O2 twice in a file)
M98 P2
M30
O2
M99
O2 (expect alarm PS0073)
M99
