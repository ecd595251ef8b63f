O1 (LEX-12: a character outside the alphabet)
G00 X1. ! (expect alarm PS0009 at !)
M30
(finally moves: none)
