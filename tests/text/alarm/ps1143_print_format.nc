O1 (PS1143: a variable without format)
DPRNT[#1] (expect alarm PS1143)
M30
