O1 (LEX-34: there is no G999)
G999 X1. (expect alarm PS0010 at G999)
M30
(finally moves: none)
