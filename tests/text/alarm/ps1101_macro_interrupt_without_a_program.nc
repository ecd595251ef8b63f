O1 (PS1101: M96 names the interrupt program)
M96 (expect alarm PS1101)
M30
