O1 (CTL-3: there is no N99)
GOTO 99 (expect alarm PS0128)
M30
