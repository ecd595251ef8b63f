O1 (EXP-7: [2+3 is not closed)
#100=[2+3 (expect alarm PS1132)
M30
