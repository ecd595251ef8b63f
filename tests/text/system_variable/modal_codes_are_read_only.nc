O1 (section 3.2: write G01 to change group 1)
#4001=1 (expect alarm PS0116)
M30
