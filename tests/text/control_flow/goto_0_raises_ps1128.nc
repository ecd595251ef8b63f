O1 (CTL-1: labels run from 1)
GOTO 0 (expect alarm PS1128)
M30
