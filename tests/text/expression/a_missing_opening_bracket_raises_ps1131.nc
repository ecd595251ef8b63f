O1 (EXP-7: 2+3] was not opened)
#100=2+3] (expect alarm PS1131)
M30
