O1 (CTL-1: labels run from 1)
GOTO[-5] (expect alarm PS1128)
N5 M30
