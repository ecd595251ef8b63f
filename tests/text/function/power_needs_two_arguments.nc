O1 (section 4.2: one argument is a format error)
#100=POW[2] (expect alarm PS1120)
M30
