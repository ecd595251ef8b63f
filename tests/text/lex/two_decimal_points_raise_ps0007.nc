O1 (LEX-25: one number has one point)
G00 X1.2.3 (expect alarm PS0007)
M30
(finally moves: none)
