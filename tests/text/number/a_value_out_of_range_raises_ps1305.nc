O1 (NUM-17: T has eight digits)
T[100000000] (expect alarm PS1305)
M30
