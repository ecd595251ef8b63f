O1 (section 3: #3006 is write only)
#100=#3006 (expect alarm PS1115)
M30
