O1 (PS1115: #3006 is write only)
#100=#3006 (expect alarm PS1115 at #3006)
M30
