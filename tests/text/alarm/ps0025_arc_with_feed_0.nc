O1 (PS0025, ARC-10: F0 in a circular block)
G02 X10. I5. F0 (expect alarm PS0025)
M30
