O1 (OUT-7: #1 alone)
DPRNT[X#1] (expect alarm PS1143)
M30
