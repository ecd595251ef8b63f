O1 (PS1144: G10 L2 has no P9)
G10 L2 P9 X0 (expect alarm PS1144 at P9)
M30
