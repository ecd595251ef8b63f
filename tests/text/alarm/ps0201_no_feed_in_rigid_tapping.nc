O1 (PS0201: F0 in the tapping block)
M29 S300
G84 X0 Y0 Z-10. R-2. F0 (expect alarm PS0201)
M30
