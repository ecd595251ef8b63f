O1 (section 7.2: 1AB is refused)
SETVN500[1AB] (expect alarm PS1141)
M30
