O1 (M99-2: the caller has no N50)
M98 P2
M30
O2
M99 P50 (expect alarm PS0078)
