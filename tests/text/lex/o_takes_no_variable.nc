O1 (LEX-8: the number behind O is a literal)
#1=2
O#1 (expect alarm PS0114)
M30
