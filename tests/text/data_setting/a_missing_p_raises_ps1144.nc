O1 (G10-2: L10 needs an offset number)
G10 L10 R1. (expect alarm PS1144)
M30
