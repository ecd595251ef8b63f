O1 (OUT-7: format 99)
DPRNT[X#1[99]] (expect alarm PS1143)
M30
