O1 (PS1132: SQRT is not closed)
#100=SQRT[4 (expect alarm PS1132)
M30
