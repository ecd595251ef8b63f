O1 (EXP-9: a slash behind ATAN[1] belongs to its second argument)
#100=ATAN[1]/2 (expect alarm PS1120)
M30
