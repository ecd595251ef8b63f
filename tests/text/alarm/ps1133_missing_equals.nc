O1 (PS1133: a variable alone)
#100 (expect alarm PS1133)
M30
