O1 (LEX-18: the block behind the slash is an ordinary one)
/G00 X1. (expect moves: rapid X1)
/9 G00 X2. (expect moves: rapid X2)
M30
