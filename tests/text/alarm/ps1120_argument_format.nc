O1 (PS1120: POW of one argument)
#100=POW[3] (expect alarm PS1120)
M30
