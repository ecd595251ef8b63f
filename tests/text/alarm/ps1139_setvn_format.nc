O1 (PS1139: SETVN without names)
SETVN500 (expect alarm PS1139)
M30
