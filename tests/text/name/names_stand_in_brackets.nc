O1 (section 7.2: SETVN without a list)
SETVN500 (expect alarm PS1139)
M30
