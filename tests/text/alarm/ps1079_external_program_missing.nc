O1 (PS1079: M198 of a program that is nowhere)
M198 P4321 (expect alarm PS1079)
M30
