O1 (PS0030: there are 400 offsets)
G43 H500 (expect alarm PS0030 at H500)
M30
