O1 (LEX-8: the number behind N is a literal)
#1=10
N#1 G00 X1. (expect alarm PS0114)
M30
(finally moves: none)
