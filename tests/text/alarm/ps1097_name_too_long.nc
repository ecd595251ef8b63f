O1 (PS1097: names have at most 8 characters)
#100=[#TOOLLENGTH] (expect alarm PS1097)
M30
