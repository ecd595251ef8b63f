O1 (PS0125)
GOTO (expect alarm PS0125)
M30
