O1 (PS0114: two operators in a row)
#100=2*/3 (expect alarm PS0114)
M30
