O1 (PS0011: a line without F)
G01 X1. (expect alarm PS0011)
M30
