O1 (PS1128: GOTO 0)
#1=0.4
GOTO#1 (expect alarm PS1128)
M30
