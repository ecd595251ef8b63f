O1 (LEX-33: one block holds one or the other)
G00 X1. #1=2 (expect alarm PS0127)
M30
(finally #1=null)
(finally moves: none)
