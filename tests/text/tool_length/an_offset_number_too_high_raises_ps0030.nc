O1 (TLC-3: there are 400 offsets)
G43 H401 Z0 (expect alarm PS0030 at H401)
M30
