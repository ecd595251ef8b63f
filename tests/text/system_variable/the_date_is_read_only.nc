O1 (section 3.1: #3011)
#3011=20010928 (expect alarm PS0116)
M30
