O1 (section 13: there is no L99)
G10 L99 P1 R1. (expect alarm PS1144)
M30
