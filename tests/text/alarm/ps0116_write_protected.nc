O1 (PS0116: a position cannot be assigned)
#5041=0 (expect alarm PS0116 at #5041)
M30
