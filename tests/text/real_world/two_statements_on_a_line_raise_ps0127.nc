O1 (an assignment and a GOTO)
#768=#601 GOTO08 (expect alarm PS0127)
N8 M30
