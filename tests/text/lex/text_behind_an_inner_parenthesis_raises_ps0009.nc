O1 (LEX-13: the second closing parenthesis is a stray one)
G00 X1. (expect moves: rapid X1)
(A(B)X2.) (expect alarm PS0009)
M30
(finally moves: rapid X1)
