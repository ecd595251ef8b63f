O1 (CALL-18: nothing to cancel)
G67 (expect alarm PS1100 at G67)
M30
