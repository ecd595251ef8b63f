O1 (PS1091: M98 twice in a block)
M98 P2 M98 P2 (expect alarm PS1091)
M30
O2
M99
