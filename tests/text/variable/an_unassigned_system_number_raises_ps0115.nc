O1 (section 2: a number above 1000 that means nothing)
#100=#1999 (expect alarm PS0115)
M30
