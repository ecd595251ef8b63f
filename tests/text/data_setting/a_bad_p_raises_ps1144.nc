O1 (G10-2: L2 takes P0 to P6)
G10 L2 P7 X0 (expect alarm PS1144 at P7)
M30
