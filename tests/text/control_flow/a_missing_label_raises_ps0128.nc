O1 (CTL-3, P33: there is no N99)
GOTO 99 (expect alarm PS0128)
M30
