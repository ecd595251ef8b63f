O1 (PS1131: a bracket closes nothing)
#100=SQRT[4]] (expect alarm PS1131)
M30
