O1 (EXP-14: IF wants a comparison)
#1=1
IF[#1]GOTO 5 (expect alarm PS1137)
N5 M30
