O1 (LEX-15: a parenthesis that nothing opened)
G00 X1.) (expect alarm PS0009)
M30
(finally moves: none)
