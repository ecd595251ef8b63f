O1 (PS0021: K does not belong to the XY plane)
G17 G02 X10. K5. F100 (expect alarm PS0021)
M30
