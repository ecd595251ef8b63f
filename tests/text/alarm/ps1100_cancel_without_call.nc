O1 (PS1100: G67 twice)
G66 P2
G67
G67 (expect alarm PS1100 at G67)
M30
O2
M99
