O1 (G10-2: L10 needs a value)
G10 L10 P1 (expect alarm PS1144)
M30
