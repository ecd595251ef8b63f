O1 (LEX-12: the plus has no address in front)
G00 X1.+2. (expect alarm PS0004)
M30
(finally moves: none)
