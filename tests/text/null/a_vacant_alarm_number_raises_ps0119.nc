O1 (NUL-12: #3000 needs a number)
#3000=#0 (VACANT) (expect alarm PS0119)
M30
