O1 (section 3.3: a position changes by moving)
#5001=1 (expect alarm PS0116)
M30
