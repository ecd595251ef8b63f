O1 (EXP-7, P28: [2+3 is not closed)
#100=[2+3 (expect alarm PS1132)
M30
