O1 (PS0128: there is no N5)
GOTO 5 (expect alarm PS0128)
M30
