O1 (CYC-12: Q0 never arrives)
G73 X0 Y0 Z-5. R1. Q0 F100 (expect alarm PS0045)
M30
