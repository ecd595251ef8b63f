O1 (PS1305: a tool number of nine digits)
#1=100000000
T#1 (expect alarm PS1305)
M30
