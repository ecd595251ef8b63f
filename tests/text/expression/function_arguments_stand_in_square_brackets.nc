O1 (EXP-15: parentheses are comments)
#100=SIN(30) (expect alarm PS0114)
M30
