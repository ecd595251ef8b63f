O1 (EXP-7: a variable and a value with nothing between)
#1 5 (expect alarm PS1133)
M30
