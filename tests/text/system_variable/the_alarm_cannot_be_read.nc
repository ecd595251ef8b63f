O1 (section 3: #3000 is write only)
#100=#3000 (expect alarm PS1115)
M30
