O1 (PS0110: an operand of more than 32 bits)
#100=1 OR 99999999999 (expect alarm PS0110)
M30
