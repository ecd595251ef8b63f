O1 (CTL-1: labels end at 99999999)
GOTO[100000000] (expect alarm PS1128)
M30
