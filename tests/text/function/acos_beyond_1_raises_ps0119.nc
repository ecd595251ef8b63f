O1 (section 4.2: domain -1 to 1)
#100=ACOS[-1.1] (expect alarm PS0119)
M30
