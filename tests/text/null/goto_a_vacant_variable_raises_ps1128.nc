O1 (NUL-7: it counts as 0, and N0 is no label)
GOTO#1 (expect alarm PS1128)
M30
