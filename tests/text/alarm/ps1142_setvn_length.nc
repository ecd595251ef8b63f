O1 (PS1142: nine letters)
SETVN500[LONGNAMES] (expect alarm PS1142)
M30
