O1 (CYC-12: G83 needs Q)
G83 X0 Y0 Z-5. R1. F100 (expect alarm PS0045)
M30
