O1 (a whole loop on one line)
#1=5
WHILE [#1 GT 2] DO1 #1= #1 - 3 (expect alarm PS0127)
END1
M30
