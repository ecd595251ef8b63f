O1 (EXP-14: only IF and WHILE compare)
#100=[2GT1] (expect alarm PS0114)
M30
