O1 (G10-2: there are 400 offsets)
G10 L10 P401 R1. (expect alarm PS0030 at P401)
M30
