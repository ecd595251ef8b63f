O1 (PS1138: WHILE without DO)
WHILE[1EQ1] (expect alarm PS1138)
M30
