O1 (LEX-8: also when the variable is vacant)
X1. O#1 (expect alarm PS0114)
M30
