O1 (LEX-7: N is a label only as the first word)
GOTO 6 (expect alarm PS0128)
N5 N6
M30
