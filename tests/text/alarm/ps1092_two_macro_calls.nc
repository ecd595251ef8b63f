O1 (PS1092: G65 and G66 in a block)
G65 P2 G66 P2 (expect alarm PS1092)
M30
O2
M99
