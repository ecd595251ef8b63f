O1 (section 3.1: a program cannot switch an input)
#1000=1 (expect alarm PS0116)
M30
