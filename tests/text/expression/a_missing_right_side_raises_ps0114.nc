O1 (EXP-7: nothing behind the equals sign)
#100= (expect alarm PS0114)
M30
