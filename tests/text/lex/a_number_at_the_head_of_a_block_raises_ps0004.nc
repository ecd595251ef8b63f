O1 (LEX-12: it has no address in front)
G90 G00 X1.
5 X2. (expect alarm PS0004)
M30
(finally moves: rapid X1)
