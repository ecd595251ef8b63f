O1 (PS0007: a tool number with point)
T1. (expect alarm PS0007 at T1.)
M30
