O1 (PS0004: a digit without address)
5 X1. (expect alarm PS0004)
M30
(finally moves: none)
