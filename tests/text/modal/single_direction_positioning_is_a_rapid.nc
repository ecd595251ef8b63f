O1 (section 8.1: G60)
G60 X10. (expect moves: rapid X10)
M30
