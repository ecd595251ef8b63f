O1 (PS1096: a name has letters, digits and underscores)
#100=[#A-B] (expect alarm PS1096)
M30
