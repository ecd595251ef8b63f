O1 (PS1098: DEPTH was never named)
#100=[#DEPTH]+1 (expect alarm PS1098)
M30
