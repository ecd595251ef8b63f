O1 (PS0045: G73 without Q)
G73 X0 Y0 Z-5. R1. F100 (expect alarm PS0045)
M30
