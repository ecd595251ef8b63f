O1 (PS0078: the caller has no N77)
M98 P2
M30
O2
M99 P77 (expect alarm PS0078)
