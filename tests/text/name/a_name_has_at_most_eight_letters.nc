O1 (section 7.2: nine are refused)
SETVN500[ABCDEFGH]
SETVN501[ABCDEFGHI] (expect alarm PS1142)
M30
