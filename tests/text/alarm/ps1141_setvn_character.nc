O1 (PS1141: a point in a name)
SETVN500[A.B] (expect alarm PS1141)
M30
