O1 (EXP-16: the plus behind X#1 has no address)
#1=1.
G90 G00 X#1+2. (expect alarm PS0004)
M30
(finally moves: none)
