O1 (LEX-12: a digit needs an address in front)
G90 G00 X1.
G01 5X (expect alarm PS0004)
M30
(finally moves: rapid X1)
